// SPDX-License-Identifier: BSD-3-Clause
// A step is a list of passes; a pass is data until it is bound to a state. Passes that stand side by side and go over
// the particles block by block are run together, block after block, so that what one leaves the next still finds at
// hand.
#pragma once

#include <compare>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "mpm/data/blocks.hpp"
#include "mpm/data/columns.hpp"
#include "mpm/step/state.hpp"

namespace assay::mpm {

/// In which stages of a step a pass runs, where the integrator has several: all; the first, in which no force acts; the
/// others.
enum class Stages { all, first, kicks };

/// The phases of a step, in their order. L and the stress are updated early where they come before the forces.
enum class Phase {
  body_force,
  inertia,
  weights,
  to_grid,
  early_gradient,
  early_stress,
  forces,
  grid,
  to_particles,
  gradient,
  accounts,
  stress
};
constexpr Phase gradient_phase(const Method& m) {
  return m.update == Update::usf ? Phase::early_gradient : Phase::gradient;
}
constexpr Phase stress_phase(const Method& m) { return m.update == Update::usf ? Phase::early_stress : Phase::stress; }

/// The places of a phase, in their order. Between the first and the last are those of what gives nodes their velocity:
/// before it what they were given goes to others; after it some are held, and some move as others do.
enum class Part { first, fold, hand_over, limit, main, hold, take_over, unfold, last };

/// Where in a step a pass stands. At the main part of a phase there is one pass.
struct Slot {
  Phase phase = Phase::body_force;
  Part part = Part::main;
  auto operator<=>(const Slot&) const = default;  // NOLINT(modernize-use-nullptr): what clang 14 makes of it
};

/// What is known of a pass without running it.
struct PassInfo {
  std::string name;
  Slot slot{Phase::stress, Part::last};
  std::string doc = {};            ///< one line
  std::string called_for_by = {};  ///< scene key; empty in an effect's file: that of the effect
  std::vector<Column> reads = {}, writes = {};
  std::vector<std::string> grid_fields = {};  ///< that it touches
  /// That bring it; empty: a pass of the spine. One that an effect's file names here is needed besides that effect.
  std::vector<std::string> effects = {};
  bool once = false;  ///< before the first step alone
  Stages stages = Stages::all;
  bool updates_material = false;  ///< of all particles
};

/// A pass bound to a state.
struct Kernel {
  using Whole = std::function<void(const Instant&)>;
  using OfBlock = std::function<std::size_t(const Instant&, const Block&)>;
  using End = std::function<void(const Instant&, std::optional<std::size_t> bad)>;

  Whole begin;  ///< before any block, or all of a pass that does not go over particles by block
  /// Null, or particles [begin, end) of a block: the first that something is wrong with, or none_bad. Safe for
  /// different blocks at once, on the inertia and force that the block names.
  OfBlock block;
  /// After the blocks, with the first particle that one of them reported.
  End end;
  bool scatters = false;  ///< to inertia or force

  Kernel() = default;
  template <class Callable>
  requires std::is_invocable_v<Callable, const Instant&> Kernel(Callable whole)
      : begin(std::move(whole)) {}  // NOLINT(google-explicit-constructor): a pass is often just this
  /// Over particles by block, and afterwards what is to be done with what the blocks reported.
  static Kernel over_blocks(OfBlock body, End after = {}) {
    Kernel kernel;
    kernel.block = std::move(body);
    kernel.end = std::move(after);
    return kernel;
  }
};

template <int Dim>
struct Pass : PassInfo {
  std::function<Kernel(State<Dim>&)> bind = {};
};

/// A kernel of a basis, over all blocks.
template <int Dim>
Kernel over_blocks(State<Dim>& s, BlockKernel<Dim> kernel, const Kernel::End& after = {}) {
  return Kernel::over_blocks([&s, kernel](const Instant& now, const Block& block) { return kernel(s, block, now); },
                             after);
}

}  // namespace assay::mpm
