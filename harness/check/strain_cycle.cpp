// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/strain_cycle.hpp"

#include <cmath>
#include <numbers>

#include "harness/check/work.hpp"
#include "harness/numeric/stable_norm.hpp"

namespace assay::check {

namespace {

/// Two shears at right angles, of equal norm, along axes of their own.
struct Plane {
  Tensor D1, D2;
};

Plane plane_of(const Specimen& specimen, double sign) {
  constexpr double angle = 0.7;
  const Tensor Q = specimen.space.turn(angle);
  Tensor stretch = Vector3(1, -1, 0).asDiagonal(), shear = Tensor::Zero();
  shear(0, 1) = shear(1, 0) = 1;
  return {sign * rotated(Q, stretch) / std::sqrt(2), rotated(Q, shear) / std::sqrt(2)};
}

/// Strain along D1 at which the stress of a step from rest has left its straight line by a tenth; nothing where it has
/// not at the amplitude.
std::optional<double> yield_strain(const Specimen& specimen, const Tensor& D1) {
  constexpr double little = 1e-3, left = 0.1;
  constexpr int halvings = 12;
  const auto share = [&](double strain) {  // of the deviator that the stiffness at rest makes
    const Tensor F = Tensor::Identity() + strain * D1;
    const Tensor sigma = stepped(*specimen.material, 0, 1, Tensor::Identity(), F, specimen.rest_state()).cauchy;
    return stable_norm(deviator(sigma)) / stable_norm(deviator(stress_of(specimen.stiffness, strain * D1)));
  };
  double lower = little * specimen.onset, upper = specimen.amplitude;
  if (share(upper) > 1 - left || share(lower) < 1 - left) return std::nullopt;
  for (int k = 0; k < halvings; ++k) {
    const double middle = std::sqrt(lower * upper);
    (share(middle) < 1 - left ? upper : lower) = middle;
  }
  return upper;
}

/// Half a circle about the strain that would be left without load, to where the load would be reversed, and straight
/// back: neither leaves what is elastic, and both pass where the direction of the load is another.
double out_of_a_cycle(const Specimen& specimen, const Plane& plane, double yield) {
  constexpr double beyond = 3;  // times the strain at yield
  const int steps = specimen.steps();
  Work work(specimen, 1.0 / steps);
  const auto to = [&](double along1, double along2) {
    work.step(Tensor::Identity() + yield * (along1 * plane.D1 + along2 * plane.D2));
  };
  for (int k = 1; k <= steps; ++k) to(beyond * k / steps, 0);
  const double before = work.done();
  const double shear = stable_norm(deviator(work.stress()));
  constexpr double least_shear = 1e-6;  // of the stress: what has only a pressure, as a gas, does not yield
  if (!(shear > least_shear * stable_norm(work.stress()))) return 0;
  const double once_more = shear * yield;
  for (int k = 1; k <= steps; ++k) {
    const double angle = std::numbers::pi * k / steps;
    to(beyond - 1 + std::cos(angle), std::sin(angle));
  }
  for (int k = 1; k <= steps; ++k) to(beyond - 2 + 2.0 * k / steps, 0);
  return (before - work.done()) / once_more;
}

}  // namespace

std::optional<double> out_of_a_cycle_after_yield(const Specimen& specimen) {
  const bool yields = specimen.linear && specimen.onset < 0.5 * specimen.amplitude;
  if (specimen.rate_dependent() || specimen.rest_pressure() > 0 || !yields) return std::nullopt;
  std::optional<double> most;
  for (const double sign : {1.0, -1.0}) {
    try {
      const Plane plane = plane_of(specimen, sign);
      const std::optional<double> yield = yield_strain(specimen, plane.D1);
      if (!yield) continue;
      const double share = out_of_a_cycle(specimen, plane, *yield);
      if (std::isfinite(share)) most = std::max(most.value_or(0), share);
    } catch (const MaterialFailure&) {  // it may not stand that much
    }
  }
  return most;
}

}  // namespace assay::check
