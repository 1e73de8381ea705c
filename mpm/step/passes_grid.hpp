// SPDX-License-Identifier: BSD-3-Clause
// Passes on the grid alone.
#pragma once

#include "mpm/step/pass.hpp"

namespace assay::mpm {

/// v_i = (m v)_i / m_i, a_i = 0: the velocity before the forces.
template <int Dim>
Pass<Dim> grid_velocity_pass(const Method& method);

/// a_i = f_i / m_i, v_i = (m v)_i / m_i + dt a_i.
template <int Dim>
Pass<Dim> grid_update_pass();

/// What holding takes from the particles' momentum, where nodes have lumped masses. PIC particles take the nodes'
/// velocities: sum m_i v_i over held nodes; FLIP ones the accelerations: sum m_i dt a_i; blends a share of each; none
/// where the velocities serve gradients alone. On the other nodes it is what they give to the mass of particles that
/// never move.
struct Reaction {
  double of_velocity = 0, of_acceleration = 0;
};
inline Reaction reaction_of(const Method& method) {
  const double kept = method.keeps_velocity() ? method.flip : 0;
  return {1 - kept, kept};
}

/// What the particles have given to the grid since it was folded last.
enum class Folded { inertia, forces, both };

/// A phase in which nodes get a velocity.
struct GridPhase {
  Phase phase;
  Folded folded;
  Reaction reaction;
};

/// Of a method: that in which the grid moves, and where L comes from another velocity the one of that.
inline std::vector<GridPhase> grid_phases(const Method& method) {
  const Folded given = method.update == Update::usf ? Folded::forces : Folded::both;
  std::vector<GridPhase> phases{{Phase::grid, given, reaction_of(method)}};
  if (method.update != Update::usl) phases.push_back({gradient_phase(method), Folded::inertia, {}});
  return phases;
}

}  // namespace assay::mpm
