// SPDX-License-Identifier: BSD-3-Clause
// That `update` reads no more than it declares, knows what is no number, and what a refused step leaves behind.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "harness/check/tests.hpp"

namespace assay::check {

namespace {

/// By how much the result of a step depends on the F with which it begins, of its stress; INFINITY where that decides
/// whether it is taken.
double trace_of_increment(const Specimen& specimen, const Tensor& F0, const Tensor& F1) {
  const Tensor I = Tensor::Identity();
  const Point before = stepped(specimen, 0, 1, I, F0, specimen.rest_state());
  const Point usual = stepped(specimen, 1, 1, F0, F1, before.state);
  const double scale = specimen.scale(size_of(usual.cauchy));
  const auto trace = [&] {
    double most = 0;
    for (const Tensor& other : {I, Tensor(0.9 * I), Tensor(1.1 * I), Tensor(specimen.space.turn(1) * F1)}) {
      const Point found = stepped(specimen, 1, 1, specimen.space.within(other), F1, before.state);
      most = std::max(most, distance(found.cauchy, usual.cauchy) / scale);
    }
    return most;
  };
  return if_taken(trace, INFINITY);
}

}  // namespace

/// A model that does not declare ASSAY_USES_INCREMENT does not read F0.
TestResult undeclared_increment(const Specimen& specimen) {
  constexpr double most = 1e-12;
  if (specimen.material->has(ASSAY_USES_INCREMENT)) {
    return left_out("the model declares that it reads F at the beginning of a step");
  }
  const double a = specimen.amplitude;
  const Tensor I = Tensor::Identity(), less = (1 - 0.1 * a) * I, more = (1 + 0.1 * a) * I;
  const Tensor out = specimen.space.stretch(a, 0.1), beyond = specimen.space.stretch(a, 0.12);
  double worst = trace_of_increment(specimen, out, beyond);
  for (const auto& ends : {std::pair(beyond, out), std::pair(less, Tensor((1 - 0.12 * a) * I)),
                           std::pair(less, Tensor((1 - 0.05 * a) * I)), std::pair(more, Tensor((1 + 0.05 * a) * I))}) {
    const auto trace = [&] {
      return trace_of_increment(specimen, specimen.space.within(ends.first), specimen.space.within(ends.second));
    };
    worst = std::max(worst, if_taken(trace, 0));  // a step that it does not stand, whatever it begins with
  }
  return judged(worst, most, "the result does not depend on F at the beginning of a step, as declared",
                causes::undeclared_increment,
                "another F at the beginning of a step changes the stress by " + rounded(worst) +
                    " of itself, and ASSAY_USES_INCREMENT is not declared");
}

namespace {

/// Whether a law of the total deformation gives a body that is turned inside out the stress of its mirror image, or
/// none at all: it takes det F without its sign, or hides that it cannot.
bool takes_the_mirror_image(const Specimen& specimen) {
  if (specimen.material->has(ASSAY_USES_INCREMENT)) return false;
  const double a = specimen.amplitude;
  const Tensor mirror = Vector3(1, 1, -1).asDiagonal();
  const Tensor F = Vector3(1 + a, 1, 1 - 0.5 * a).asDiagonal();
  const auto takes_it = [&] {
    const Tensor image = stress_at_once(specimen, F), found = stress_at_once(specimen, F * mirror);
    const double scale = size_of(image);
    return scale > specimen.least_stress() && (distance(found, image) <= own_precision * scale || found.isZero(0));
  };
  return if_taken(takes_it, false);  // it should refuse
}

}  // namespace

/// F that is not a number, infinite, or turned inside out is refused or comes back as no number; nothing worse.
TestResult senseless_deformation(const Specimen& specimen) {
  const auto answered = [&](double value, int place) {
    Tensor F = Tensor::Identity();
    component(F, place) = value;
    return if_taken([&] { return stress_at_once(specimen, F).allFinite(); }, false);
  };
  const bool of_nothing = answered(std::numeric_limits<double>::quiet_NaN(), 1);
  const bool of_infinity = answered(std::numeric_limits<double>::infinity(), 0), inverted = answered(-0.5, 8);
  const bool mirrored = takes_the_mirror_image(specimen);
  return judged(of_nothing || mirrored ? 1 : 0, 0,
                of_infinity ? "an infinite F has a finite stress; an F that is not a number is refused"
                : inverted  ? "an F with det F < 0 has a stress; an F that is infinite or not a number is refused"
                            : "an F that is not a number, is infinite or has det F < 0 is refused",
                causes::not_a_number,
                of_nothing ? "an F that is not a number has a finite stress, which hides an error of the caller"
                           : "an F with det F < 0 has the stress of its mirror image, or none, which hides an error of "
                             "the caller");
}

namespace {

/// A step of one point: refused by the model's own word, or stress and state, one after the other.
struct Answer {
  bool refused = false, finite = true;
  std::vector<double> values;
};

Answer asked(const Material& material, const FailedStep& step) {
  Answer answer{false, true, std::vector<double>(9 + step.state0.size())};
  double* const values = answer.values.data();
  const UpdateReport report = material.update(step.t, step.dt, 1, nine_of(step.F0).data(), nine_of(step.F1).data(),
                                              step.state0.data(), values + 9, values);
  answer.finite = !report.not_finite;
  answer.refused = report.worst == ASSAY_FAILED && answer.finite;
  return answer;
}

/// Of the stress to its own largest component, of the state each to itself.
double difference(const Answer& expected, const Answer& found) {
  if (found.refused != expected.refused || found.finite != expected.finite) return INFINITY;
  double scale = 0, worst = 0;
  for (std::size_t c = 0; c < 9; ++c) scale = std::max(scale, std::abs(expected.values[c]));
  for (std::size_t c = 0; c < expected.values.size(); ++c) {
    const double own = c < 9 ? scale : std::abs(expected.values[c]);
    const double change = std::abs(found.values[c] - expected.values[c]);
    if (change > 0) worst = std::max(worst, change / (own > 0 ? own : 1));
  }
  return worst;
}

/// A deformation that grows with `size` [1], and how it is called.
struct Growing {
  const char* name;
  std::function<Tensor(double size)> F;
};

std::vector<Growing> growing(const Space& space) {
  const auto shear = [](double size) {
    Tensor F = Tensor::Identity();
    F(0, 1) = size;
    return F;
  };
  return {{"an extension by ",
           [](double size) {
             const double l = 1 + size;
             return Tensor(Vector3(l, 1 / std::sqrt(l), 1 / std::sqrt(l)).asDiagonal());
           }},
          {"a shear by ", shear},
          {"a shear, turned, by ", [=](double size) { return rotated(space.turn(turning_angle), shear(size)); }},
          {"an expansion by ", [](double size) { return Tensor((1 + size) * Tensor::Identity()); }},
          {"a compression by ", [](double size) { return Tensor(Tensor::Identity() / (1 + size)); }}};
}

/// What is wrong after a refusal, and by how much; empty: nothing.
struct Trace {
  bool any_refused = false;
  std::string words;
  double measure = 0;
};

constexpr double as_before = 1e-12;  // as in calls.repeated

/// Asks for a refused step and all that was answered before it once more.
void look_for_trace(const Material& material, const FailedStep& refused, const std::string& where,
                    const std::vector<std::pair<FailedStep, Answer>>& before, Trace& trace) {
  trace.any_refused = true;
  double worst = 0;
  for (const auto& [step, answer] : before) worst = std::max(worst, difference(answer, asked(material, step)));
  if (!asked(material, refused).refused) {
    trace.measure = INFINITY;
    trace.words = where + ", which it refused, is taken when it is repeated";
  } else if (worst > as_before) {
    trace.measure = worst;
    trace.words =
        "after " + where + ", which it refuses, the earlier steps have other results; they differ by " + rounded(worst);
  }
}

/// In steps from rest that grow until the model refuses one.
Trace trace_of_refusals(const Specimen& specimen) {
  const Material material = specimen.material->clone();  // what is left in it spoils no other test
  std::vector<std::pair<FailedStep, Answer>> before;
  const auto step_to = [&](const Tensor& F) { return FailedStep{0, 1, Tensor::Identity(), F, specimen.rest_state()}; };
  for (const double s : {0.2, 0.5, 0.9}) {
    const FailedStep step = step_to(specimen.stretch(s));
    before.emplace_back(step, asked(material, step));
  }
  Trace trace;
  for (const Growing& way : growing(specimen.space)) {
    constexpr double first = 0.25, largest = 16;
    for (double size = first; size <= largest && trace.words.empty(); size *= 2) {
      const FailedStep step = step_to(specimen.space.within(way.F(size)));
      Answer answer = asked(material, step);
      if (answer.refused) {
        look_for_trace(material, step, way.name + rounded(size), before, trace);
        break;
      }
      before.emplace_back(step, std::move(answer));
    }
  }
  return trace;
}

/// A step and those of which F differs in the thirteenth digit.
struct Neighbours {
  std::optional<Answer> taken;  ///< of the nearest that is
  bool mixed = false;           ///< some are refused
};

Neighbours around(const Material& material, FailedStep step, const Tensor& direction, int on_either_side) {
  constexpr double digits = 1e-13;
  const Tensor F1 = step.F1;
  Neighbours result;
  bool any_refused = false;
  for (int k = 0; k <= on_either_side; ++k) {
    for (const int side : {k, -k}) {
      step.F1 = F1 + side * digits * direction;
      Answer answer = asked(material, step);
      any_refused |= answer.refused;
      if (!answer.refused && answer.finite && !result.taken) result.taken = std::move(answer);
    }
  }
  result.mixed = any_refused && result.taken;
  return result;
}

/// Whether the last digits of F decide any of many short steps in place of a long one. Of a law whose iterations end in
/// short steps they do not, however wild they are in long ones.
bool decide_short_steps(const Specimen& specimen, const FailedStep& whole, const Tensor& direction) {
  constexpr int parts = 32, on_either_side = 32;
  FailedStep step = whole;
  const Tensor way = whole.F1 - whole.F0;
  step.dt = whole.dt / parts;
  for (int k = 0; k < parts; ++k) {
    step.t = whole.t + k * step.dt;
    step.F0 = whole.F0 + k * way / parts;
    step.F1 = whole.F0 + (k + 1) * way / parts;
    const Neighbours found = around(*specimen.material, step, direction, on_either_side);
    if (found.mixed) return true;
    if (!found.taken) return false;
    step.state0.assign(found.taken->values.begin() + 9, found.taken->values.end());
  }
  return false;
}

/// Of the long steps of a history to a strain, the share of those that the last digits of F decide; 0 where they decide
/// no short ones.
double share_by_last_digits(const Specimen& specimen, double strain) {
  constexpr int steps = 5, on_either_side = 16;
  constexpr double out = 0.33;  // of the path, before it turns back
  const Tensor direction = specimen.space.stretch(1, 0.3);
  FailedStep step{0, 1.0 / steps, Tensor::Identity(), Tensor::Identity(), specimen.rest_state()};
  int mixed = 0;
  for (int k = 1; k <= steps; ++k) {
    step.t = (k - 1) * step.dt;
    step.F0 = step.F1;
    step.F1 = specimen.space.stretch(strain, out * k / steps);
    const Neighbours found = around(*specimen.material, step, direction, on_either_side);
    mixed += found.mixed ? 1 : 0;
    if (!found.taken || k == steps) break;
    step.state0.assign(found.taken->values.begin() + 9, found.taken->values.end());
  }
  return mixed > 0 && decide_short_steps(specimen, step, direction) ? static_cast<double>(mixed) / steps : 0;
}

/// Of histories of several strains; of a model that has refused nothing of the battery, nothing is asked.
double share_by_last_digits(const Specimen& specimen) {
  double worst = 0;
  if (!specimen.has_refused && !specimen.options.has_refused) return worst;
  for (const double smaller : {1.0, 1.0 / 8}) {
    worst = std::max(worst, share_by_last_digits(specimen, smaller * Effort{}.strain));
  }
  return worst;
}

}  // namespace

/// A step that the model refuses is refused again, and leaves no trace in what it answers; and it is not the last
/// digits of F that decide what is refused.
TestResult refusals(const Specimen& specimen) {
  constexpr double most_by_digits = 0.1;  // less than one step
  if (specimen.options.declarations.guesses_roles) {
    return left_out("foreign routines are left out, because they may end the process in such steps");
  }
  const double share = share_by_last_digits(specimen);
  if (share > most_by_digits) {
    return failed(causes::refuses, share, most_by_digits,
                  "the last digits of F decide which steps are refused, in " + percent(share) +
                      " of the steps of a history: for example, the tolerance of an iteration is below its rounding "
                      "errors");
  }
  const Trace trace = trace_of_refusals(specimen);
  if (!trace.any_refused) return left_out("no step is refused, up to a strain of 16");
  return judged(trace.measure, as_before,
                "a step that is refused is refused again, and leaves no trace in what is answered after it",
                causes::hidden_state, "a refusal leaves a trace in the instance: " + trace.words);
}

}  // namespace assay::check
