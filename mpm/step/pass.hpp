// SPDX-License-Identifier: BSD-3-Clause
// A step is a list of passes; a pass is data until it is bound to a state. Passes that stand side by side and go over
// the particles block by block are run together, block after block, so that what one leaves the next still finds at
// hand.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "mpm/data/blocks.hpp"
#include "mpm/data/columns.hpp"
#include "mpm/data/effect.hpp"
#include "mpm/data/instant.hpp"
#include "mpm/step/state.hpp"

namespace assay::mpm {

/// In which stages of a step a pass runs, where the integrator has several: all; the first, in which no force acts; the
/// others.
enum class Stages { all, first, kicks };

/// What is known of a pass without running it.
struct PassInfo {
  std::string name;
  std::string doc;            ///< one line
  std::string called_for_by;  ///< scene key
  std::vector<Column> reads, writes;
  std::vector<std::string> grid_fields;  ///< that it touches
  std::vector<Effect> effects;           ///< without one of which it is not there; empty: a pass of the spine
  bool once = false;                     ///< before the first step alone
  Stages stages = Stages::all;
};

/// A pass bound to a state.
struct Kernel {
  using Whole = std::function<void(const Instant&)>;

  Whole begin;  ///< before any block, or all of a pass that does not go over particles by block
  /// Null, or particles [begin, end) of a block: the first that something is wrong with, or none_bad. Safe for
  /// different blocks at once, on the inertia and force that the block names.
  std::function<std::size_t(const Instant&, const Block&)> block;
  /// After the blocks, with the first particle that one of them reported.
  std::function<void(const Instant&, std::optional<std::size_t> bad)> end;
  bool scatters = false;  ///< to inertia or force

  Kernel() = default;
  template <class Callable>
  requires std::is_invocable_v<Callable, const Instant&> Kernel(Callable whole)
      : begin(std::move(whole)) {}  // NOLINT(google-explicit-constructor): a pass is often just this
};

template <int Dim>
struct Pass : PassInfo {
  std::function<Kernel(State<Dim>&)> bind;
};

}  // namespace assay::mpm
