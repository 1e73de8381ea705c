// SPDX-License-Identifier: BSD-3-Clause
// Passes from particles to grid: weights, mass and momentum, forces.
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

}  // namespace assay::mpm
