// SPDX-License-Identifier: BSD-3-Clause
// The tangent modulus of a material's own step, by differences; its acoustic tensor, and the extremes of that over all
// directions.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "harness/material/material.hpp"

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

/// Steps of many points from t on, each with its state before.
struct ProbedStep {
  Tensor F0, F1;
  std::vector<double> state0;
};
std::vector<TangentModulus> probe_tangent_moduli(const Material& material, double t, double dt,
                                                 std::span<const ProbedStep> steps, double size);

/// Size of differences that suits most materials [1].
inline constexpr double difference_of_F = 1e-5;  ///< central: error about 1e-10 relative, round-off about 1e-11

/// Smallest or largest eigenvalue of sym(N.A.N), (N.A.N)_ik = A_iJkL N_J N_L, over all unit vectors N.
struct AcousticExtreme {
  double value = 0;                  ///< [Pa]
  Vector3 normal = Vector3::Zero();  ///< N, in the reference configuration
};
AcousticExtreme smallest_acoustic_eigenvalue(const TangentModulus& A);
AcousticExtreme largest_acoustic_eigenvalue(const TangentModulus& A);

}  // namespace assay
