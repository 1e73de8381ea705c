// SPDX-License-Identifier: BSD-3-Clause
// Other forms of the vortex's force and stress, to compare with.
#pragma once

#include <cmath>

#include "harness/exact/polar.hpp"
#include "harness/motion/kinds/vortex.hpp"

namespace assay {

/// DIV(T) in the Cauchy form: d sigma11/dR + (sigma11 - sigma22)/R, d sigma12/dR + 2 sigma12/R, in baseline components
/// at fixed t [N/m^3]. Independent of divergence_piola; the two agree to round-off.
inline Polar divergence_cauchy(const RingProfile& p, double g, double R, const Tensor& given,
                               const Tensor& given_slope) {
  const auto [tau, dtau_dxi] = balanced(p, g, given, given_slope);
  Tensor F = Tensor::Identity(), dF_dR = Tensor::Zero();
  F(1, 0) = 2 * g * p.xi;  // (16); J = 1, so sigma = tau F^T
  dF_dR(1, 0) = 2 * g * p.xi_prime;
  const Tensor sigma = tau * F.transpose();
  const Tensor dsigma_dR = p.xi_prime * dtau_dxi * F.transpose() + tau * dF_dR.transpose();
  return {dsigma_dR(0, 0) + (sigma(0, 0) - sigma(1, 1)) / R, dsigma_dR(0, 1) + 2 * sigma(0, 1) / R};
}

/// b from the radius and the time.
inline Polar body_force(const Vortex& vortex, double density, double R, double t, const Tensor& tau,
                        const Tensor& dtau_dxi) {
  return body_force(vortex.profile(R), vortex.amplitude.at(t), density, R, tau, dtau_dxi);
}

/// T = r tau q^T (20) [Pa] for the reference point X.
inline Tensor rotated_to(const Vortex& vortex, const Vector3& X, double t, const Tensor& tau) {
  const double Theta = std::atan2(X.y(), X.x());
  const double theta = Theta + vortex.amplitude.at(t).value * vortex.profile(std::hypot(X.x(), X.y())).h;  // (17)
  return rotation_about_z(theta) * tau * rotation_about_z(Theta).transpose();
}

}  // namespace assay
