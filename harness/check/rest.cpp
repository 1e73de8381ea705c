// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/rest.hpp"

#include <algorithm>
#include <cmath>

#include "harness/check/rigid_turn.hpp"

namespace assay::check {

TestResult stress_at_rest(const Specimen& specimen) {
  constexpr double most = 1e-6;  // of the modulus: single precision leaves 1e-7
  const Tensor I = Tensor::Identity();
  const Material& material = *specimen.material;
  const Point rest = stepped(material, 0, 1, I, I, specimen.rest_state());
  stepped(material, 2, 1, I, I, stepped(material, 1, 1, I, I, rest.state).state);  // a stress of zero divides nothing
  const double measure = distance(rest.cauchy, -specimen.pressure * I) / specimen.modulus;
  TestResult result{.id = "rest", .measure = measure, .threshold = most};
  result.sentence = "stress over modulus of a body that was never deformed: " + rounded(measure);
  if (measure <= most) return result;
  result.verdict = Verdict::fail;
  result.cause = causes::stress_at_rest;
  if (specimen.pressure == 0) return result;
  const Point later = stepped(material, 1, 1, I, I, rest.state);
  const bool goes_on = distance(later.cauchy, rest.cauchy) > most * specimen.modulus;
  result.cause = goes_on && !specimen.rate_dependent() ? causes::drifts : causes::initial_stress;
  result.sentence = "a step without deformation changes the pressure at which a body is at rest, by " +
                    rounded(measure) + " of the modulus" + (goes_on ? ", and the next one changes it again" : "");
  return result;
}

TestResult symmetry(const Specimen& specimen) {
  constexpr double of_deviator = 0.05, significant = 1e-4;  // single precision leaves 1e-7 of the largest component
  const int steps = specimen.steps();
  Point now{Tensor::Zero(), specimen.rest_state()};
  Tensor F0 = Tensor::Identity();
  double largest = specimen.least_stress(), deviator = 0, skew = 0;
  for (int k = 0; k < steps; ++k) {
    const double s = (k + 1.0) / steps;
    const Tensor F1 = specimen.space.turn(2 * s) * specimen.space.stretch(specimen.amplitude, s);
    now = stepped(*specimen.material, 1.0 * k / steps, 1.0 / steps, F0, F1, now.state);
    const Tensor dev = now.cauchy - now.cauchy.trace() / 3 * Tensor::Identity();
    largest = std::max(largest, now.cauchy.cwiseAbs().maxCoeff());
    deviator = std::max(deviator, dev.cwiseAbs().maxCoeff());
    skew = std::max(skew, distance(now.cauchy, now.cauchy.transpose()));
    F0 = F1;
  }
  TestResult result{.id = "symmetry", .measure = skew / largest, .threshold = own_precision};
  if (deviator > significant * largest && skew > of_deviator * deviator) {  // beside a large pressure
    result.measure = skew / deviator;
    result.threshold = of_deviator;
  }
  result.verdict = *result.measure <= *result.threshold ? Verdict::pass : Verdict::fail;
  result.sentence =
      "sigma - sigma^T over the stress, of a body that turns while it is loaded: " + rounded(*result.measure);
  if (result.verdict == Verdict::fail) result.cause = causes::not_symmetric;
  return result;
}

namespace {

/// What steps without deformation change whose length goes to zero: a model that relaxes does so in time. A first one
/// takes away what depends on the rate of deformation.
TestResult no_time(const Specimen& specimen) {
  constexpr int repeats = 30;
  const Material& material = *specimen.material;
  const double a = specimen.amplitude;
  const Loading loading{[&](double t) { return specimen.space.stretch(a, 0.3 * t); }, 1};
  const March loaded = march(material, loading, {.steps = specimen.steps(), .state = specimen.rest_state()});
  const Tensor F = loading.F(1);
  double least = INFINITY;
  for (const double length : {1e-6, 1e-9, 1e-12}) {
    const Point first = stepped(material, 1, length, F, F, loaded.marks[0].state);
    Point now = first;
    for (int repeat = 0; repeat < repeats; ++repeat) now = stepped(material, 1, length, F, F, now.state);
    least = std::min(least, distance(now.cauchy, first.cauchy) / std::max(loaded.largest, specimen.least_stress()));
  }
  TestResult result{.id = "zero_increment", .measure = least, .threshold = converging_limit};
  result.verdict = least <= converging_limit ? Verdict::pass : Verdict::fail;
  result.sentence = "thirty steps without deformation, and in no time, change the stress by " + rounded(least);
  if (result.verdict == Verdict::pass) return result;
  result.cause = causes::drifts;
  result.sentence += " of the largest: it relaxes by the step, not by the time";
  return result;
}

}  // namespace

TestResult zero_increment(const Specimen& specimen) {
  TestResult result{.id = "zero_increment"};
  if (specimen.rate_dependent()) return no_time(specimen);
  const Material& material = *specimen.material;
  const double a = specimen.amplitude;
  std::array<double, 3> errors{};
  for (int k = 0; k < 3; ++k) {
    const Loading loading{[&](double t) { return specimen.space.stretch(a, 0.3 * t); }, 1};
    const March loaded = march(material, loading, {.steps = specimen.steps() << k, .state = specimen.rest_state()});
    const Tensor F = loading.F(1);
    Point now = loaded.marks[0];
    for (int repeat = 0; repeat < 3; ++repeat) now = stepped(material, 1, 0.01, F, F, now.state);
    errors[static_cast<std::size_t>(k)] =
        distance(now.cauchy, loaded.marks[0].cauchy) / std::max(loaded.largest, specimen.least_stress());
  }
  const Limit limit = limit_of(errors);
  result.measure = limit.value;
  result.threshold = converging_limit;
  result.order = limit.order;
  result.verdict = limit.passes() ? Verdict::pass : Verdict::fail;
  if (result.verdict == Verdict::fail) result.cause = causes::drifts;
  result.sentence = "three steps without deformation: " + how(limit, errors, specimen.steps());
  return result;
}

}  // namespace assay::check
