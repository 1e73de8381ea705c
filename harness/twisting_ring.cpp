// SPDX-License-Identifier: BSD-3-Clause
#include "harness/twisting_ring.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace assay {

namespace {

/// sin(pi t/T) with its first two rates [1], [1/s], [1/s^2].
AmplitudeValue half_wave(double t, double period) { return Amplitude{Amplitude::Type::sine, 1, period}.at(t); }

}  // namespace

TwistingRing::Radial TwistingRing::radial(double R) const {
  const double ri = twist.inner, ro = twist.outer, d = ro * ro * (ro - 3 * ri);
  const double c1 = -6 * ri * ro / d, c2 = 3 * (ri + ro) / d, c3 = -2 / d;
  return {R * (c1 + R * (c2 + R * c3)), c1 + R * (2 * c2 + 3 * R * c3)};
}

RingKinematics TwistingRing::ring(double R, double t) const {
  RingKinematics k = twist.ring(R, t);
  const Radial u = radial(R);
  const AmplitudeValue s = half_wave(t, period());
  k.rho = R + expansion * s.value * u.U;
  k.rho_slope = 1 + expansion * s.value * u.slope;
  k.rho_rate = expansion * s.rate * u.U;
  k.rho_slope_rate = expansion * s.rate * u.slope;
  k.rho_acceleration = expansion * s.acceleration * u.U;
  k.rho_slope_acceleration = expansion * s.acceleration * u.slope;
  return k;
}

ExactState TwistingRing::at(const Vector3& X, double t) const { return ring(std::hypot(X.x(), X.y()), t).state(X); }

Path TwistingRing::baseline() const {
  Path path;
  path.name = "twisting_ring";
  path.parameter = {inner(), outer()};
  path.parameter_is_place = true;
  path.curved = [m = *this](double R, double t) {
    const RingKinematics k = m.ring(R, t);
    return PathPoint{k.baseline(R), k.baseline_rate(R)};
  };
  path.reversals = [m = *this](double end) {
    std::vector<double> times = m.twist.amplitude.reversals(end);
    for (const double t : Amplitude{Amplitude::Type::sine, 1, m.period()}.reversals(end)) times.push_back(t);
    std::sort(times.begin(), times.end());
    const auto same = [&](double a, double b) { return b - a <= 1e-12 * m.period(); };
    times.erase(std::unique(times.begin(), times.end(), same), times.end());
    return times;
  };
  return path;
}

}  // namespace assay
