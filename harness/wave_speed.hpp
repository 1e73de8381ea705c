// SPDX-License-Identifier: BSD-3-Clause
// The fastest acoustic wave that a material carries along a baseline path: what limits an explicit time step.
#pragma once

#include <Eigen/Core>

#include "harness/material.hpp"
#include "harness/path.hpp"

namespace assay {

/// A = d P / d F [Pa], row and column by the row-major index of the tensors.
using TangentModulus = Eigen::Matrix<double, 9, 9>;

/// A of the material's own step of length dt from state0 at F, by central differences of `update`: never a foreign
/// tangent. Throws MaterialFailure (point_driver.hpp).
TangentModulus probe_tangent_modulus(const Material& material, double t, double dt, const Tensor& F,
                                     const std::vector<double>& state0);

/// The same about a step from F0 to F1, with differences of that size [1]. Smaller than the step, they stay on the
/// branch that the step is on: the loading branch of a material with kinks.
TangentModulus probe_tangent_modulus(const Material& material, double t, double dt, const Tensor& F0, const Tensor& F1,
                                     const std::vector<double>& state0, double size);

/// Largest c over all directions with rho0 c^2 an eigenvalue of A_iJkL N_J N_L, N = F^T n, |n| = 1 [m/s].
double fastest_wave(const TangentModulus& A, const Tensor& F, double density);

/// The largest over the path, 0 <= t <= end [m/s]: the material's own (assay.wave_speed/1) or the probed one.
/// density: rho0 [kg/m^3]. Throws MaterialFailure.
double fastest_wave_on_path(const Material& material, const Path& path, double density, double end);

}  // namespace assay
