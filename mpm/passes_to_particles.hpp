// SPDX-License-Identifier: BSD-3-Clause
// Passes from grid to particles: motion and velocity gradient.
#pragma once

#include "mpm/pass.hpp"

namespace assay::mpm {

/// x += dt sum phi v_i; FLIP, AFLIP: v += dt sum phi a_i; the others: v = sum phi v_i; or a blend of both;
/// [L = sum v_i (x) grad phi]; [work of the body force into the ledger].
template <int Dim>
Pass<Dim> grid_to_particles_pass(const Method& method, bool with_velocity_gradient, bool with_work);

/// L = sum v_i (x) grad phi_ip alone.
template <int Dim>
Pass<Dim> velocity_gradient_pass();

}  // namespace assay::mpm
