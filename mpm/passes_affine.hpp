// SPDX-License-Identifier: BSD-3-Clause
// Passes of APIC and AFLIP: the velocity around a particle, from the grid's new one. Templates on the basis.
#pragma once

#include "mpm/pass.hpp"

namespace assay::mpm {

/// Gradient: C = L (I + dt L)^-1 so that an affine motion of the grid is the particle's after it has moved; L = B D^-1
/// (fits_gradient) or sum v_i (x) grad phi_ip; total: C = dF/dt. Moment: B = sum phi_ip v_i (x) r_i, of which
/// particles_to_grid makes C = B D^-1. knows_gradient: the step's velocity_gradient is that of the grid's new velocity.
template <class B, int Dim>
Pass<Dim> affine_pass(const Method& method, bool knows_gradient);

/// The first moment of the initial velocity, whose gradient the column holds before the first step.
template <class B, int Dim>
Pass<Dim> first_affine_moment_pass();

}  // namespace assay::mpm
