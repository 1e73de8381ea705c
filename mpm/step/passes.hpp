// SPDX-License-Identifier: BSD-3-Clause
// The passes that every step has, and those that it has in several ways: weights, from particles to the grid, on the
// grid, and back to the particles.
#pragma once

#include "mpm/step/pass.hpp"

namespace assay::mpm {

/// phi_ip and grad phi_ip of the step, or, in the reference configuration, of all steps; finds particles outside the
/// grid. domains_differ: each particle has its own.
template <int Dim>
Pass<Dim> weights_pass(const Method& method, bool domains_differ);

/// m_i = sum phi_ip m_p, (m v)_i = sum phi_ip m_p (v_p [+ C_p r_i]), r_i from the particle to the node.
template <int Dim>
Pass<Dim> particles_to_grid_pass(const Method& method);

/// f_i = - sum V_p sigma_p grad phi_ip [+ sum phi_ip m_p b_p], V_p = J V_0; total: V_0 P_p in place of V_p sigma_p.
template <int Dim>
Pass<Dim> force_pass(const Method& method, bool with_body_force);

/// Both at once, under the first one's name: the weights are made once.
template <int Dim>
Pass<Dim> particles_and_forces_to_grid_pass(const Method& method, bool with_body_force);

/// v_i = (m v)_i / m_i, a_i = 0: the velocity before the forces.
template <int Dim>
Pass<Dim> grid_velocity_pass(const Method& method);

/// a_i = f_i / m_i, v_i = (m v)_i / m_i + dt a_i.
template <int Dim>
Pass<Dim> grid_update_pass();

/// Whether grid_to_particles fits the affine velocity, too: where it moves corners it has read what that takes.
template <int Dim>
bool fits_with_corners(const Method& method);

/// x += dt sum phi v_i; x_c += dt sum N_i(x_c) v_i of corners that move one by one; FLIP, AFLIP: v += dt sum phi a_i;
/// the others: v = sum phi v_i; or a blend of both; [L = sum v_i (x) grad phi]; [work of the body force into the
/// ledger].
template <int Dim>
Pass<Dim> grid_to_particles_pass(const Method& method, bool with_velocity_gradient, bool with_work);

/// L = sum v_i (x) grad phi_ip alone.
template <int Dim>
Pass<Dim> velocity_gradient_pass(const Method& method);

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

// Nodes that particles reach by their slopes alone (massless_nodes.cpp). A particle on a line between cells has no
// weight at the nodes across, or one of rounding, but a slope of 1/h: its velocity gradient takes the velocity of nodes
// that have no mass to have one, and its stress gives them forces that nothing takes up.

/// Whether particles can lie where their weights vanish and slopes do not: with the linear basis anywhere; with
/// B-splines on the grid's edge, where the node there alone has a weight, and only a body that begins there does. Those
/// of the other bases vanish together.
template <int Dim>
bool has_massless_nodes(const Setup<Dim>& setup);

/// Mass, momentum and force of nodes of less than 1e-11 rho0 h^Dim go to the nearest neighbours that have more, by
/// their masses: along the axes; where none has, across the diagonals. Nodes that are held keep theirs. What is handed
/// over in a step is kept in sum.
template <int Dim>
Pass<Dim> fold_massless_pass(Phase phase, Folded what);

/// Those nodes move as these neighbours do, by their masses.
template <int Dim>
Pass<Dim> unfold_massless_pass(Phase phase);

}  // namespace assay::mpm
