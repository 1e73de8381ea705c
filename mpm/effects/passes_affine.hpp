// SPDX-License-Identifier: BSD-3-Clause
// Passes of APIC and AFLIP: the velocity around a particle, from the grid's new one.
#pragma once

#include "mpm/step/pass.hpp"

namespace assay::mpm {

/// Gradient: C = L (I + dt L)^-1 so that an affine motion of the grid is the particle's after it has moved; L = B D^-1
/// (fits_gradient) or sum v_i (x) grad phi_ip; total: C = dF/dt. Moment: B = sum phi_ip v_i (x) r_i, of which
/// particles_to_grid makes C = B D^-1.
template <int Dim>
Pass<Dim> affine_pass(const Method& method);

/// The first moment of the initial velocity, whose gradient the column holds before the first step.
template <int Dim>
Pass<Dim> first_affine_moment_pass();

}  // namespace assay::mpm
