// SPDX-License-Identifier: BSD-3-Clause
// The tangent modulus of a material's own step, by differences.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "harness/material.hpp"

namespace assay {

/// A = d P / d F [Pa], row and column by the row-major index of the tensors.
using TangentModulus = Eigen::Matrix<double, 9, 9>;

/// A of the material's own step of length dt from state0 at F, by central differences of `update`: never a foreign
/// tangent. Zero by components that the material does not take (ASSAY_IN_PLANE). Throws MaterialFailure.
TangentModulus probe_tangent_modulus(const Material& material, double t, double dt, const Tensor& F,
                                     const std::vector<double>& state0);

/// The same about a step from F0 to F1, with differences of that size [1]. Smaller than the step, they stay on the
/// branch that the step is on: the loading branch of a material with kinks.
TangentModulus probe_tangent_modulus(const Material& material, double t, double dt, const Tensor& F0, const Tensor& F1,
                                     const std::vector<double>& state0, double size);

}  // namespace assay
