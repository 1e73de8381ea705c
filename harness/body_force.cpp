// SPDX-License-Identifier: BSD-3-Clause
#include "harness/body_force.hpp"

#include <algorithm>
#include <cmath>

namespace assay {

Polar divergence_piola(const Vortex& vortex, double R, double t, const Tensor& tau, const Tensor& dtau_dxi) {
  const Vortex::Profile p = vortex.profile(R);
  const double g = vortex.amplitude.at(t).value;
  return {p.xi_prime * dtau_dxi(0, 0) - g * p.h_prime * tau(1, 0) + (tau(0, 0) - tau(1, 1)) / R,   // (26)
          p.xi_prime * dtau_dxi(1, 0) + g * p.h_prime * tau(0, 0) + (tau(0, 1) + tau(1, 0)) / R};  // (27)
}

Polar divergence_cauchy(const Vortex& vortex, double R, double t, const Tensor& tau, const Tensor& dtau_dxi) {
  const Vortex::Profile p = vortex.profile(R);
  const double g = vortex.amplitude.at(t).value;
  Tensor F = Tensor::Identity(), dF_dR = Tensor::Zero();
  F(1, 0) = 2 * g * p.xi;  // (16); J = 1, so sigma = tau F^T
  dF_dR(1, 0) = 2 * g * p.xi_prime;
  const Tensor sigma = tau * F.transpose();
  const Tensor dsigma_dR = p.xi_prime * dtau_dxi * F.transpose() + tau * dF_dR.transpose();
  return {dsigma_dR(0, 0) + (sigma(0, 0) - sigma(1, 1)) / R, dsigma_dR(0, 1) + 2 * sigma(0, 1) / R};
}

Polar body_force(const Vortex& vortex, double density, double R, double t, const Tensor& tau, const Tensor& dtau_dxi) {
  const Vortex::Profile p = vortex.profile(R);
  if (p.h == 0 && p.xi_prime == 0) return {};
  const AmplitudeValue g = vortex.amplitude.at(t);
  const double omega = g.rate * p.h;  // (30)
  const Polar divergence = divergence_piola(vortex, R, t, tau, dtau_dxi);
  return {-R * omega * omega - divergence.r / density,             // (32)
          R * g.acceleration * p.h - divergence.theta / density};  // (33), sign of the inertia term corrected
}

Tensor rotated_to(const Vortex& vortex, const Vector3& X, double t, const Tensor& tau) {
  const double Theta = std::atan2(X.y(), X.x());
  const double R = std::hypot(X.x(), X.y());
  const double theta = Theta + vortex.amplitude.at(t).value * vortex.profile(R).h;  // (17)
  return rotation_about_z(theta) * tau * rotation_about_z(Theta).transpose();       // (20)
}

BodyForceField::BodyForceField(const Vortex& vortex, double density, std::span<const double> X,
                               std::span<const double> Y)
    : vortex_(vortex), density_(density), points_(X, Y), force_(points_.radius.size()) {
  for (const double R : points_.radius) {
    const Vortex::Profile p = vortex.profile(R);
    h_.push_back(p.h);
    xi_.push_back(p.xi);
  }
}

void BodyForceField::evaluate(const Response& response, double t, std::span<double> b_x, std::span<double> b_y) {
  const double g = vortex_.amplitude.at(t).value;
  response.at_time(t, xi_, [&](std::size_t k, const Tensor& tau, const Tensor& dtau_dxi) {
    const Polar b = body_force(vortex_, density_, points_.radius[k], t, tau, dtau_dxi);
    const double c = std::cos(g * h_[k]), s = std::sin(g * h_[k]);
    force_[k] = {c * b.r - s * b.theta, s * b.r + c * b.theta};  // along E_R, E_Theta
  });
  for (std::size_t i = 0; i < points_.ring.size(); ++i) {
    const Polar& b = force_[points_.ring[i]];
    b_x[i] = points_.cos_theta[i] * b.r - points_.sin_theta[i] * b.theta;
    b_y[i] = points_.sin_theta[i] * b.r + points_.cos_theta[i] * b.theta;
  }
}

}  // namespace assay
