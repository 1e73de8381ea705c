// SPDX-License-Identifier: BSD-3-Clause
// The fastest acoustic wave that a material carries along a baseline path: what limits an explicit time step.
#pragma once

#include "harness/path.hpp"
#include "harness/tangent_modulus.hpp"

namespace assay {

/// Largest c over all directions with rho0 c^2 an eigenvalue of A_iJkL N_J N_L, N = F^T n, |n| = 1 [m/s].
double fastest_wave(const TangentModulus& A, const Tensor& F, double density);

/// The largest over the path, 0 <= t <= end [m/s]: the material's own (assay.wave_speed/1) or the probed one.
/// density: rho0 [kg/m^3]. Throws MaterialFailure.
double fastest_wave_on_path(const Material& material, const Path& path, double density, double end);

}  // namespace assay
