// SPDX-License-Identifier: BSD-3-Clause
#include "harness/motion/ring_kinematics.hpp"

#include <cmath>

namespace assay {

namespace {

double angle_of(const Vector3& X) { return std::atan2(X.y(), X.x()); }

}  // namespace

RingKinematics RingKinematics::turned(double R, const RingProfile& p, const AmplitudeValue& g) {
  RingKinematics k;
  k.rho = R;
  k.alpha = g.value * p.h;      // (5)
  k.alpha_rate = g.rate * p.h;  // (30)
  k.alpha_acceleration = g.acceleration * p.h;
  k.alpha_slope = g.value * p.h_prime;
  k.alpha_slope_rate = g.rate * p.h_prime;
  k.alpha_slope_acceleration = g.acceleration * p.h_prime;
  return k;
}

void RingKinematics::widen(const RingRadial& u, const AmplitudeValue& w) {
  rho += w.value * u.U;
  rho_slope += w.value * u.slope;
  rho_rate = w.rate * u.U;
  rho_slope_rate = w.rate * u.slope;
  rho_acceleration = w.acceleration * u.U;
  rho_slope_acceleration = w.acceleration * u.slope;
}

Tensor RingKinematics::baseline(double R) const {
  Tensor B = Tensor::Identity();
  B(0, 0) = rho_slope;
  B(1, 0) = rho * alpha_slope;
  B(1, 1) = R > 0 ? rho / R : rho_slope;
  return B;
}

Tensor RingKinematics::baseline_rate(double R) const {
  Tensor B = Tensor::Zero();
  B(0, 0) = rho_slope_rate;
  B(1, 0) = rho_rate * alpha_slope + rho * alpha_slope_rate;
  B(1, 1) = rho_rate / R;
  return B;
}

Polar RingKinematics::acceleration() const {
  return {rho_acceleration - rho * alpha_rate * alpha_rate, rho * alpha_acceleration + 2 * rho_rate * alpha_rate};
}

Polar RingKinematics::acceleration_slope() const {
  return {rho_slope_acceleration - rho_slope * alpha_rate * alpha_rate - 2 * rho * alpha_rate * alpha_slope_rate,
          rho_slope * alpha_acceleration + rho * alpha_slope_acceleration +
              2 * (rho_slope_rate * alpha_rate + rho_rate * alpha_slope_rate)};
}

ExactState RingKinematics::state(const Vector3& X) const {
  const double R = std::hypot(X.x(), X.y());
  const Tensor q = rotation_about_z(angle_of(X)), r = rotation_about_z(angle_of(X) + alpha);
  Tensor spin = Tensor::Zero();  // r. = r spin
  spin(0, 1) = -alpha_rate, spin(1, 0) = alpha_rate;
  ExactState state;
  state.x = cartesian(X, {rho, 0}) + Vector3(0, 0, X.z());
  state.v = cartesian(X, {rho_rate, rho * alpha_rate});
  state.a = cartesian(X, acceleration());
  state.F = r * baseline(R) * q.transpose();
  state.F_rate = r * (spin * baseline(R) + baseline_rate(R)) * q.transpose();
  return state;
}

Polar RingKinematics::divergence(double R, const Tensor& tau, const Tensor& dtau_dR) const {
  return {dtau_dR(0, 0) - alpha_slope * tau(1, 0) + (tau(0, 0) - tau(1, 1)) / R,
          dtau_dR(1, 0) + alpha_slope * tau(0, 0) + (tau(0, 1) + tau(1, 0)) / R};
}

Polar RingKinematics::body_force(double density, double R, const Tensor& tau, const Tensor& dtau_dR) const {
  const Polar a = acceleration(), div = divergence(R, tau, dtau_dR);
  return {a.r - div.r / density, a.theta - div.theta / density};
}

Tensor RingKinematics::first_piola_kirchhoff(const Vector3& X, const Tensor& tau) const {
  const double Theta = angle_of(X);
  return rotation_about_z(Theta + alpha) * tau * rotation_about_z(Theta).transpose();
}

Vector3 RingKinematics::cartesian(const Vector3& X, const Polar& v) const {
  return rotation_about_z(angle_of(X) + alpha) * Vector3(v.r, v.theta, 0);
}

}  // namespace assay
