// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/calls.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "harness/check/judge.hpp"

namespace assay::check {

namespace {

/// By how much the result of a step depends on the F with which it begins, of its stress; INFINITY where that decides
/// whether it is taken.
double trace_of_increment(const Specimen& specimen, const Tensor& F0, const Tensor& F1) {
  const Material& material = *specimen.material;
  const Tensor I = Tensor::Identity();
  const Point before = stepped(material, 0, 1, I, F0, specimen.rest_state());
  const Point usual = stepped(material, 1, 1, F0, F1, before.state);
  const double scale = std::max(usual.cauchy.cwiseAbs().maxCoeff(), specimen.least_stress());
  double most = 0;
  try {
    for (const Tensor& other : {I, Tensor(0.9 * I), Tensor(1.1 * I), Tensor(specimen.space.turn(1) * F1)}) {
      const Point found = stepped(material, 1, 1, specimen.space.within(other), F1, before.state);
      most = std::max(most, distance(found.cauchy, usual.cauchy) / scale);
    }
  } catch (const MaterialFailure&) {
    return INFINITY;
  }
  return most;
}

}  // namespace

TestResult undeclared_increment(const Specimen& specimen) {
  constexpr double most = 1e-12;
  TestResult result{.id = "calls.increment", .measure = 0, .threshold = most};
  result.sentence = "the result does not depend on F at the beginning of a step, as declared";
  if (specimen.material->has(ASSAY_USES_INCREMENT)) {
    result = {.id = "calls.increment", .verdict = Verdict::not_applicable};
    result.sentence = "the model declares that it reads F at the beginning of a step";
    return result;
  }
  const double a = specimen.amplitude;
  const Tensor I = Tensor::Identity(), less = (1 - 0.1 * a) * I, more = (1 + 0.1 * a) * I;
  const Tensor out = specimen.space.stretch(a, 0.1), beyond = specimen.space.stretch(a, 0.12);
  result.measure = trace_of_increment(specimen, out, beyond);
  for (const auto& [F0, F1] :
       {std::pair(beyond, out), std::pair(less, Tensor((1 - 0.12 * a) * I)),
        std::pair(less, Tensor((1 - 0.05 * a) * I)), std::pair(more, Tensor((1 + 0.05 * a) * I))}) {
    try {
      const Tensor from = specimen.space.within(F0), to = specimen.space.within(F1);
      result.measure = std::max(*result.measure, trace_of_increment(specimen, from, to));
    } catch (const MaterialFailure&) {  // a step that it does not stand, whatever it begins with
    }
  }
  if (*result.measure <= most) return result;
  result.verdict = Verdict::fail;
  result.cause = causes::undeclared_increment;
  result.sentence = "another F at the beginning of a step changes the stress by " + rounded(*result.measure) +
                    " of itself, and ASSAY_USES_INCREMENT is not declared";
  return result;
}

namespace {

/// Whether a law of the total deformation gives a body that is turned inside out the stress of its mirror image, or
/// none at all: it takes det F without its sign, or hides that it cannot.
bool takes_the_mirror_image(const Specimen& specimen) {
  if (specimen.material->has(ASSAY_USES_INCREMENT)) return false;
  const double a = specimen.amplitude;
  const Tensor I = Tensor::Identity(), mirror = Vector3(1, 1, -1).asDiagonal();
  const Tensor F = Vector3(1 + a, 1, 1 - 0.5 * a).asDiagonal();
  try {
    const Tensor image = stepped(*specimen.material, 0, 1, I, F, specimen.rest_state()).cauchy;
    const Tensor found = stepped(*specimen.material, 0, 1, I, F * mirror, specimen.rest_state()).cauchy;
    const double scale = image.cwiseAbs().maxCoeff();
    return scale > specimen.least_stress() && (distance(found, image) <= own_precision * scale || found.isZero(0));
  } catch (const MaterialFailure&) {  // as it should
    return false;
  }
}

}  // namespace

TestResult senseless_deformation(const Specimen& specimen) {
  const Material& material = *specimen.material;
  const Tensor I = Tensor::Identity();
  TestResult result{.id = "calls.senseless", .measure = 0, .threshold = 0};
  const auto answered = [&](double value, int place) {
    Tensor F = I;
    component(F, place) = value;
    try {
      return stepped(material, 0, 1, I, F, specimen.rest_state()).cauchy.allFinite();
    } catch (const MaterialFailure&) {
      return false;
    }
  };
  const bool of_nothing = answered(std::numeric_limits<double>::quiet_NaN(), 1);
  const bool of_infinity = answered(std::numeric_limits<double>::infinity(), 0), inverted = answered(-0.5, 8);
  result.sentence = of_infinity ? "an infinite F has a finite stress; an F that is not a number is refused"
                    : inverted  ? "an F with det F < 0 has a stress; an F that is infinite or not a number is refused"
                                : "an F that is not a number, is infinite or has det F < 0 is refused";
  const bool mirrored = takes_the_mirror_image(specimen);
  if (!of_nothing && !mirrored) return result;
  result.measure = 1;
  result.verdict = Verdict::fail;
  result.cause = causes::not_a_number;
  result.sentence =
      of_nothing
          ? "an F that is not a number has a finite stress, which hides an error of the caller"
          : "an F with det F < 0 has the stress of its mirror image, or none, which hides an error of the caller";
  return result;
}

}  // namespace assay::check
