// SPDX-License-Identifier: BSD-3-Clause
// Passes between particles and grid: weights, mass and momentum, forces, velocities. Templates on the basis.
#pragma once

#include "mpm/pass.hpp"

namespace assay::mpm {

/// phi_ip and grad phi_ip of the step; finds particles outside the grid.
template <class B, int Dim>
Pass<Dim> weights_pass();

/// m_i = sum phi_ip m_p, (m v)_i = sum phi_ip m_p v_p.
template <class B, int Dim>
Pass<Dim> particles_to_grid_pass(bool hold_outside);

/// f_i = - sum V_p sigma_p grad phi_ip [+ sum phi_ip m_p b_p], V_p = J V_0.
template <class B, int Dim>
Pass<Dim> force_pass(bool with_body_force);

/// x += dt sum phi v_i; FLIP: v += dt sum phi a_i; PIC: v = sum phi v_i; [L = sum v_i (x) grad phi];
/// [work of the body force into the ledger].
template <class B, int Dim>
Pass<Dim> grid_to_particles_pass(Transfer transfer, bool with_velocity_gradient, bool with_work);

/// L = sum v_i (x) grad phi_ip alone.
template <class B, int Dim>
Pass<Dim> velocity_gradient_pass();

}  // namespace assay::mpm
