// SPDX-License-Identifier: BSD-3-Clause
// Everything that a running simulation owns; passes work on it.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <typeindex>
#include <vector>

#include "harness/material/material_failure.hpp"
#include "mpm/grid/live_nodes.hpp"
#include "mpm/kernels/kernels.hpp"
#include "mpm/setup/setup.hpp"

namespace assay::mpm {

/// Why a run must stop: a result, not an error.
struct Finding {
  enum class Kind { unstable, material_failed };
  Kind kind = Kind::unstable;
  std::string reason;                   ///< one sentence
  std::int64_t particle = 0;            ///< permanent id
  std::optional<FailedStep> step = {};  ///< of a material that failed
};

/// Momentum and energy since t = 0. What the particles have is compared with what was given to them.
struct Ledger {
  std::array<double, 3> impulse{};          ///< of body force and holding reactions [N s]
  std::array<double, 3> angular_impulse{};  ///< of the body force, about the origin; in the plane about E_z [N m s]
  double external_work = 0;                 ///< of the body force [J]
  double internal_work = 0;                 ///< of the stress [J]
  /// Of the grid's momentum about the origin, affine parts of the particles included, before a step's forces: the
  /// first, its largest difference to that and the impulse given since, and the largest sum of |x m v| [N m s].
  std::optional<std::array<double, 3>> grid_angular;
  double grid_angular_defect = 0, grid_angular_scale = 0;
  std::array<double, 3> angular_impulse_before{};  ///< this step [N m s]
  double mass_defect = 0;                          ///< largest |grid mass - particle mass| / particle mass
};

/// sum += x cross f; in the plane its third component alone.
template <std::size_t Dim>
void add_moment(std::array<double, 3>& sum, double factor, const std::array<double, Dim>& x,
                const std::array<double, Dim>& f) {
  if constexpr (Dim == 3) {
    sum[0] += factor * (x[1] * f[2] - x[2] * f[1]);
    sum[1] += factor * (x[2] * f[0] - x[0] * f[2]);
  }
  sum[2] += factor * (x[0] * f[1] - x[1] * f[0]);
}

/// Where a thread adds up what its tile gives to the grid; zero between tiles.
template <int Dim>
struct TileCopy {
  GridField<Dim + 1> inertia;
  GridField<Dim> force;
};

template <int Dim>
struct State : KernelState<Dim> {
  explicit State(Setup<Dim> s) : KernelState<Dim>{s.method, s.seeds.size()}, setup(std::move(s)) {}

  Setup<Dim> setup;
  LiveNodes<Dim> live{setup.grid};  ///< in which all nodal fields are kept up to date
  std::vector<TileCopy<Dim>> tile_copies;
  std::optional<Finding> finding;
  Ledger ledger;
  std::int64_t material_calls = 0;  ///< points updated
  /// Marks nodes beside those that particles reach: once a step, before their images are.
  std::vector<std::function<void(LiveNodes<Dim>&)>> markers;

  /// What passes have in common and no other knows, one of each type: made by the first that asks for it. It lives as
  /// long as the state, and a pass asks once, when it is bound.
  template <class T>
  T& own() {
    std::shared_ptr<void>& kept = owned_[typeid(T)];
    if (!kept) kept = std::make_shared<T>();
    return *static_cast<T*>(kept.get());
  }
  /// Null where nobody has asked for it.
  template <class T>
  const T* find() const {
    const auto kept = owned_.find(typeid(T));
    return kept == owned_.end() ? nullptr : static_cast<const T*>(kept->second.get());
  }

 private:
  std::map<std::type_index, std::shared_ptr<void>> owned_;
};

/// What never moves: mass of particles, a node, and nodes; empty where nothing is held.
struct Held {
  std::vector<double> mass;
  std::vector<double> force;  ///< of their initial stress, Dim components a node; empty where there is none [N]
  std::vector<std::uint32_t> nodes;
};

/// Those of the setup's basis, made once.
template <int Dim>
const Kernels<Dim>& kernels_for(State<Dim>& s) {
  auto& kernels = s.template own<Kernels<Dim>>();
  if (!kernels.place) kernels = kernels_of<Dim>(s.setup.method.basis, s.setup.instructions);
  return kernels;
}

}  // namespace assay::mpm
