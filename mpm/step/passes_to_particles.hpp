// SPDX-License-Identifier: BSD-3-Clause
// Passes from grid to particles: motion, corners of domains, velocity gradient.
#pragma once

#include "mpm/step/pass.hpp"

namespace assay::mpm {

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

}  // namespace assay::mpm
