// SPDX-License-Identifier: BSD-3-Clause
#include "harness/motion/twisting_ring.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "harness/motion/path_recipe.hpp"

namespace assay {

AmplitudeValue TwistingRing::widening(double t, double period) {
  return Amplitude{Amplitude::Type::sine, 1, period}.at(t);
}

TwistingRing::Radial TwistingRing::radial(double R) const {
  const double ri = twist.inner, ro = twist.outer, d = ro * ro * (ro - 3 * ri);
  const double c1 = -6 * ri * ro / d, c2 = 3 * (ri + ro) / d, c3 = -2 / d;
  return {R * (c1 + R * (c2 + R * c3)), c1 + R * (2 * c2 + 3 * R * c3)};
}

void TwistingRing::widen(RingKinematics& k, double expansion, const Radial& u, const AmplitudeValue& s) {
  k.rho += expansion * s.value * u.U;
  k.rho_slope += expansion * s.value * u.slope;
  k.rho_rate = expansion * s.rate * u.U;
  k.rho_slope_rate = expansion * s.rate * u.slope;
  k.rho_acceleration = expansion * s.acceleration * u.U;
  k.rho_slope_acceleration = expansion * s.acceleration * u.slope;
}

RingKinematics TwistingRing::ring(double R, double t) const {
  RingKinematics k = twist.ring(R, t);
  widen(k, expansion, radial(R), widening(t, period()));
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
  path.recipe = recipe_of(*this);
  return path;
}

}  // namespace assay
