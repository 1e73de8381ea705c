// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/viscosity.hpp"

#include <algorithm>

#include "harness/check/judge.hpp"
#include "harness/numeric/stable_norm.hpp"

namespace assay::check {

namespace {

/// Of a model without memory: the least power of what its stress is in motion beyond that at rest in the same place,
/// over the largest that stresses and rates of their sizes can have; at a rate of strain of 1/time.
double least_power_of_motion(const Specimen& specimen, double time) {
  constexpr double strain = 1e-4, noticed = 1e-3;  // of a step; of the stress
  const Material& material = *specimen.material;
  Tensor mixed;
  mixed << 0.6, 0.4, -0.3, 0.4, -0.5, 0.2, -0.3, 0.2, 0.3;
  const Tensor shear = mixed - mixed.trace() / 3 * Tensor::Identity();
  double least = 0;
  for (const double s : {0.0, 0.15, 0.3, 0.5}) {
    const Tensor F0 = specimen.space.stretch(specimen.amplitude, s);
    for (const Tensor& along : {Tensor(Tensor::Identity()), mixed, shear}) {
      for (const double sign : {1.0, -1.0}) {
        const Tensor d = specimen.space.within(sign / along.norm() * along);
        const Tensor F1 = (Tensor::Identity() + strain * d) * F0;
        const double dt = strain * time;
        const Tensor moved = stepped(material, 0, dt, F0, F1, specimen.rest_state()).cauchy;
        const Tensor held = stepped(material, 0, dt, F1, F1, specimen.rest_state()).cauchy;
        const Tensor more = moved - held;
        const double size = stable_norm(more);
        if (size < noticed * (stable_norm(moved) + stable_norm(held)) || size < specimen.least_stress()) continue;
        least = std::min(least, (more / size).cwiseProduct(d).sum() / d.norm());
      }
    }
  }
  return least;
}

}  // namespace

std::optional<TestResult> viscosity(const Specimen& specimen, const std::vector<double>& times) {
  constexpr double most = 0.02;
  const Material& material = *specimen.material;
  if (!specimen.rate_dependent() || material.state_size() > 0 || !material.has(ASSAY_USES_INCREMENT))
    return std::nullopt;
  double worst = 0;
  for (const double time : times) {
    try {
      worst = std::max(worst, -least_power_of_motion(specimen, time));
    } catch (const MaterialFailure&) {  // of the length of a step
    }
  }
  if (worst <= most) return std::nullopt;
  TestResult result{.id = "dissipation", .verdict = Verdict::fail, .measure = worst, .threshold = most};
  result.cause = causes::dissipation;
  result.sentence =
      "the stress that motion adds gives work instead of taking it, in one of two opposite motions at least";
  return result;
}

}  // namespace assay::check
