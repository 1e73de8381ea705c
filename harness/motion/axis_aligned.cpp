// SPDX-License-Identifier: BSD-3-Clause
#include "harness/motion/axis_aligned.hpp"

#include <cmath>
#include <numbers>

#include "harness/motion/path_recipe.hpp"

namespace assay {

namespace {

using std::numbers::pi;

/// g = pi A sin(c pi t), d u_x / d X where cos(pi X) = 1 [1].
AmplitudeValue strain(const Amplitude& amplitude, double t) {
  AmplitudeValue g = amplitude.at(t);
  g.value *= pi, g.rate *= pi, g.acceleration *= pi;
  return g;
}

}  // namespace

ExactState AxisAligned::at(const Vector3& X, double t) const {
  const AmplitudeValue g = strain(amplitude, t);
  ExactState state;
  state.x = X;
  for (int d = 0; d < (one_dimensional ? 1 : 2); ++d) {
    const double sign = d == 0 ? 1 : -1, sine = sign * std::sin(pi * X(d)) / pi, cosine = sign * std::cos(pi * X(d));
    state.x(d) += g.value * sine;
    state.v(d) = g.rate * sine;
    state.a(d) = g.acceleration * sine;
    state.F(d, d) += g.value * cosine;
    state.F_rate(d, d) = g.rate * cosine;
  }
  return state;
}

Tensor AxisAligned::acceleration_gradient(const Vector3& X, double t) const {
  const double g = strain(amplitude, t).acceleration;
  Tensor gradient = Tensor::Zero();
  gradient(0, 0) = g * std::cos(pi * X.x());
  if (!one_dimensional) gradient(1, 1) = -g * std::cos(pi * X.y());
  return gradient;
}

Path AxisAligned::section(double s) const {
  Path path;
  path.parameter = {-1, 1};
  path.reversals = [g = amplitude](double end) { return g.reversals(end); };
  path.recipe = recipe_of(*this, s);
  if (!one_dimensional) {
    path.name = "axis_aligned";
    path.parameter_is_place = true;
    path.curved = [g = amplitude, s](double xi, double t) {
      const AmplitudeValue now = strain(g, t);
      PathPoint point;
      point.F.diagonal() += now.value * Vector3(xi, -s, 0);
      point.F_rate.diagonal() = now.rate * Vector3(xi, -s, 0);
      return point;
    };
    return path;
  }
  path.name = "uniaxial_strain";
  path.direction(0, 0) = 1;
  path.amplitude = [g = amplitude](double t) { return strain(g, t).value; };
  path.amplitude_rate = [g = amplitude](double t) { return strain(g, t).rate; };
  path.amplitude_range = [g = amplitude](double end) {
    const auto [lower, upper] = g.range(end);
    return Interval{pi * lower, pi * upper};
  };
  return path;
}

}  // namespace assay
