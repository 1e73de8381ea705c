// SPDX-License-Identifier: BSD-3-Clause
#include "harness/exact/body_force.hpp"
#include "harness/motion/kinds/vortex.hpp"

#include <algorithm>
#include <cmath>

namespace assay {

namespace {

struct BaselineStress {
  Tensor tau, dtau_dxi;
};

/// With J sigma = tau F^T symmetric: interpolation is only to its error, by which the two forms of the divergence would
/// differ. A stress further from symmetry is the model's own, and stays.
BaselineStress balanced(const RingProfile& p, double g, const Tensor& tau, const Tensor& dtau_dxi) {
  constexpr double error_at_most = 1e-5;
  const double gamma = 2 * g * p.xi, gamma_slope = 2 * g;  // sigma12 = tau12 + gamma tau11, sigma21 = tau21
  const double pushed = gamma * tau(0, 0), pushed_slope = gamma * dtau_dxi(0, 0) + gamma_slope * tau(0, 0);
  const double half = 0.5 * (tau(0, 1) + pushed - tau(1, 0));
  const double half_slope = 0.5 * (dtau_dxi(0, 1) + pushed_slope - dtau_dxi(1, 0));
  BaselineStress result{tau, dtau_dxi};
  if (std::abs(half) > error_at_most * tau.cwiseAbs().maxCoeff()) return result;
  if (std::abs(half_slope) > error_at_most * dtau_dxi.cwiseAbs().maxCoeff()) return result;
  result.tau(1, 0) += half;
  result.tau(0, 1) = result.tau(1, 0) - pushed;
  result.dtau_dxi(1, 0) += half_slope;
  result.dtau_dxi(0, 1) = result.dtau_dxi(1, 0) - pushed_slope;
  return result;
}

}  // namespace

Polar divergence_piola(const RingProfile& p, double g, double R, const Tensor& given, const Tensor& given_slope) {
  const auto [tau, dtau_dxi] = balanced(p, g, given, given_slope);
  return {p.xi_prime * dtau_dxi(0, 0) - g * p.h_prime * tau(1, 0) + (tau(0, 0) - tau(1, 1)) / R,   // (26)
          p.xi_prime * dtau_dxi(1, 0) + g * p.h_prime * tau(0, 0) + (tau(0, 1) + tau(1, 0)) / R};  // (27)
}

Polar divergence_cauchy(const RingProfile& p, double g, double R, const Tensor& given, const Tensor& given_slope) {
  const auto [tau, dtau_dxi] = balanced(p, g, given, given_slope);
  Tensor F = Tensor::Identity(), dF_dR = Tensor::Zero();
  F(1, 0) = 2 * g * p.xi;  // (16); J = 1, so sigma = tau F^T
  dF_dR(1, 0) = 2 * g * p.xi_prime;
  const Tensor sigma = tau * F.transpose();
  const Tensor dsigma_dR = p.xi_prime * dtau_dxi * F.transpose() + tau * dF_dR.transpose();
  return {dsigma_dR(0, 0) + (sigma(0, 0) - sigma(1, 1)) / R, dsigma_dR(0, 1) + 2 * sigma(0, 1) / R};
}

Polar body_force(const RingProfile& p, const AmplitudeValue& g, double density, double R, const Tensor& tau,
                 const Tensor& dtau_dxi) {
  if (p.h == 0 && p.xi_prime == 0) return {};
  const double omega = g.rate * p.h;  // (30)
  const Polar divergence = divergence_piola(p, g.value, R, tau, dtau_dxi);
  return {-R * omega * omega - divergence.r / density,             // (32)
          R * g.acceleration * p.h - divergence.theta / density};  // (33), sign of the inertia term corrected
}

Tensor rotated_to(const Vortex& vortex, const Vector3& X, double t, const Tensor& tau) {
  const double Theta = std::atan2(X.y(), X.x());
  const double R = std::hypot(X.x(), X.y());
  const double theta = Theta + vortex.amplitude.at(t).value * vortex.profile(R).h;  // (17)
  return rotation_about_z(theta) * tau * rotation_about_z(Theta).transpose();       // (20)
}

BodyForceField::BodyForceField(const Motion& motion, double density, std::span<const double> X,
                               std::span<const double> Y)
    : motion_(motion), density_(density), points_(X, Y), force_(points_.radius.size()) {
  for (const double R : points_.radius) {
    profile_.push_back(motion->polar()->profile(R));
    xi_.push_back(ring_parameter(motion, R).value);
  }
  if (motion->polar()->widens()) rings_ = RingsInMotion(motion, points_.radius);
}

void BodyForceField::evaluate(const Response& response, double t, std::span<double> b_x, std::span<double> b_y) {
  const bool widens = motion_->polar()->widens();
  const AmplitudeValue g = motion_->polar()->turn().at(t);
  if (widens) rings_.set_time(t);
  response.at_time(t, xi_, [&](std::size_t k, const Tensor& tau, const Tensor& dtau_dxi) {
    const double R = points_.radius[k];
    const Polar b = widens ? rings_[k].body_force(density_, R, tau, dtau_dxi)
                           : body_force(profile_[k], g, density_, R, tau, dtau_dxi);
    const double alpha = g.value * profile_[k].h;  // (5)
    const double c = std::cos(alpha), s = std::sin(alpha);
    force_[k] = {c * b.r - s * b.theta, s * b.r + c * b.theta};  // along E_R, E_Theta
  });
  for (std::size_t i = 0; i < points_.ring.size(); ++i) {
    const Polar& b = force_[points_.ring[i]];
    b_x[i] = points_.cos_theta[i] * b.r - points_.sin_theta[i] * b.theta;
    b_y[i] = points_.sin_theta[i] * b.r + points_.cos_theta[i] * b.theta;
  }
}

}  // namespace assay
