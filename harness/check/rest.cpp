// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/rest.hpp"

#include <algorithm>
#include <cmath>

#include "harness/check/judge.hpp"
#include "harness/check/precision.hpp"
#include "harness/check/rigid_turn.hpp"

namespace assay::check {

TestResult stress_at_rest(const Specimen& specimen) {
  constexpr double most = 1e-6;  // of the modulus: single precision leaves 1e-7
  const Tensor I = Tensor::Identity();
  const Material& material = *specimen.material;
  const Point rest = stepped(material, 0, 1, I, I, specimen.rest_state());
  stepped(material, 2, 1, I, I, stepped(material, 1, 1, I, I, rest.state).state);  // a stress of zero divides nothing
  const double measure = distance(rest.cauchy, -specimen.rest_pressure() * I) / specimen.modulus;
  TestResult result{.id = "rest", .measure = measure, .threshold = most};
  result.sentence = "stress of the undeformed body, relative to the modulus: " + rounded(measure);
  if (specimen.own_pressure > 0) {
    result.sentence = std::string(remark_words) + "the material has a pressure at rest, " +
                      rounded(specimen.own_pressure) + " Pa, which free faces cannot balance";
  }
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

bool pressed_at_rest(const Specimen& specimen) {
  const Tensor I = Tensor::Identity();
  const Tensor stress = stepped(*specimen.material, 0, 1, I, I, specimen.rest_state()).cauchy;
  return distance(deviator(stress), Tensor::Zero()) <= own_precision * stress.cwiseAbs().maxCoeff();
}

bool grows_at_rest(const Specimen& specimen) {
  constexpr double significant = 1e-6, none = 1e-3, alike = 0.1, brief = 1e-6;  // of the modulus, of it, of it; [s]
  const Tensor I = Tensor::Identity();
  const auto stress_after = [&](double time, int steps) {
    Point now{Tensor::Zero(), specimen.rest_state()};
    for (int k = 0; k < steps; ++k) {
      now = stepped(*specimen.material, time * k / steps, time / steps, I, I, now.state);
    }
    return Tensor(now.cauchy + specimen.rest_pressure() * I);
  };
  try {
    const Tensor whole = stress_after(1, 1), parts = stress_after(1, 10);
    const double size = whole.cwiseAbs().maxCoeff();
    return size > significant * specimen.modulus && stress_after(brief, 1).cwiseAbs().maxCoeff() < none * size &&
           distance(whole, parts) < alike * size;
  } catch (const MaterialFailure&) {
    return false;
  }
}

namespace {

/// The largest sigma - sigma^T that was seen [Pa], beside the largest stress and deviator.
struct Skew {
  double largest, deviator = 0, skew = 0;
};

void look_at_stress(const Specimen& specimen, const Loading& loading, Skew& seen) {
  const int steps = specimen.steps() * loading.phases;
  Point now{Tensor::Zero(), specimen.rest_state()};
  Tensor F0 = loading.F(0);
  for (int k = 0; k < steps; ++k) {
    const double s = (k + 1.0) / steps;
    const Tensor F1 = loading.F(loading.phases * s);
    now = stepped(*specimen.material, s, 1.0 / steps, F0, F1, now.state);
    seen.largest = std::max(seen.largest, now.cauchy.cwiseAbs().maxCoeff());
    seen.deviator = std::max(seen.deviator, deviator(now.cauchy).cwiseAbs().maxCoeff());
    seen.skew = std::max(seen.skew, distance(now.cauchy, now.cauchy.transpose()));
    F0 = F1;
  }
}

}  // namespace

TestResult symmetry(const Specimen& specimen) {
  constexpr double of_deviator = 0.05, significant = 1e-4;
  constexpr double rounding = 1e-9;  // of double precision, with what iterations leave; single leaves 1e-7
  Skew seen{specimen.least_stress()};
  const Loading still = out_and_back(specimen);
  const auto turning = [&](double t) { return Tensor(specimen.space.turn(t) * still.F(t)); };
  look_at_stress(specimen, {turning, still.phases}, seen);
  const auto sheared = [&](double t) {
    Tensor F = Tensor::Identity();
    component(F, 1) = specimen.amplitude * (t < 1 ? t : 2 - t);
    return F;
  };
  try {
    look_at_stress(specimen, {sheared, 2}, seen);
  } catch (const MaterialFailure&) {  // the strain was not tried in shear
  }
  const double measure = seen.skew / seen.largest;
  const bool is_single = measure > rounding && is_of_single_precision(specimen);
  TestResult result{.id = "symmetry", .measure = measure, .threshold = is_single ? own_precision : rounding};
  if (seen.deviator > significant * seen.largest && seen.skew > of_deviator * seen.deviator) {  // beside a pressure
    result.measure = seen.skew / seen.deviator;
    result.threshold = of_deviator;
  }
  result.verdict = *result.measure <= *result.threshold ? Verdict::pass : Verdict::fail;
  result.sentence =
      "sigma - sigma^T relative to the stress, for a body that rotates while it is loaded: " + rounded(*result.measure);
  if (result.verdict == Verdict::fail) result.cause = causes::not_symmetric;
  return result;
}

namespace {

/// What steps without deformation change whose length goes to zero: a model that relaxes does so in time. A first one
/// takes away what depends on the rate of deformation.
TestResult no_time(const Specimen& specimen) {
  constexpr int repeats = 31;  // odd: what goes to and fro does not come back
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
  result.sentence = "31 steps without deformation, and in no time, change the stress by " + rounded(least);
  if (result.verdict == Verdict::pass) return result;
  result.cause = causes::drifts;
  result.sentence += " of the largest stress: the relaxation follows the number of steps, not the time";
  return result;
}

}  // namespace

namespace {

/// What a step brings and the next one, without deformation, takes away.
double taken_away(const Specimen& specimen, const Point& from, double strain, double length) {
  const Material& material = *specimen.material;
  const Tensor F0 = specimen.space.stretch(specimen.amplitude, 0.3);
  const Tensor F1 = specimen.space.stretch(specimen.amplitude, 0.3 + strain);
  const Point moved = stepped(material, 1, length, F0, F1, from.state);
  return distance(moved.cauchy, stepped(material, 1 + length, length, F1, F1, moved.state).cauchy);
}

/// A stress of the rate of deformation is one of strain over time. One that comes with each step, the more the larger
/// its strain and however short it is, and is gone with the next, vanishes as steps become short.
void judge_rate(const Specimen& specimen, TestResult& result) {
  constexpr double strain = 0.02, same = 1e-6, significant = 1e-3;
  const Loading loading{[&](double t) { return specimen.space.stretch(specimen.amplitude, 0.3 * t); }, 1};
  const March loaded = march(*specimen.material, loading, {.steps = specimen.steps(), .state = specimen.rest_state()});
  const auto taken = [&](double of_strain, double length) {
    return taken_away(specimen, loaded.marks[0], of_strain, length);
  };
  const double usual = taken(strain, 1e-4);
  if (!(usual > significant * strain * specimen.amplitude * specimen.modulus)) return;
  if (!(std::abs(taken(strain, 1e-6) - usual) <= same * usual)) return;  // longer ones may be told from these
  const double share = taken(0.5 * strain, 1e-4) / usual;
  if (!(share < 0.97)) return;  // a stress of the direction of the rate alone
  result.verdict = Verdict::fail;
  result.cause = causes::drifts;
  result.measure = usual / std::max(loaded.largest, specimen.least_stress());
  result.sentence =
      "a step without deformation removes the stress of the step before it, however short both are: the stress follows "
      "the step, not the rate";
}

constexpr double top_of_pauses = 0.3;  ///< of the stretch

/// What many steps without deformation in the middle of a loading leave in the stress that follows, over the largest
/// deviator: a pressure may be many times what flow and hardening bring.
double trace_of_pause(const Specimen& specimen, int steps, double at, const Point& before) {
  constexpr int pause = 101;  // odd
  // What is forgotten in a pause may show in unloading alone, come back soon or show late: the ends are compared.
  const double ends[] = {at, 0.25, 0.32, 0.4, 1};
  const Material& material = *specimen.material;
  const double a = specimen.amplitude;
  const Loading then{[&](double t) {
                       const int k = std::min(3, static_cast<int>(t));
                       return specimen.space.stretch(a, ends[k] + (t - k) * (ends[k + 1] - ends[k]));
                     },
                     4};
  const Tensor F = then.F(0);
  Point paused = before;
  for (int repeat = 0; repeat < pause; ++repeat) paused = stepped(material, 1, 0.01, F, F, paused.state);
  const MarchOptions on{.steps = steps / 2, .begin = 1, .state = before.state};
  MarchOptions later = on;
  later.state = paused.state;
  const March at_once = march(material, then, on), after_it = march(material, then, later);
  // The first step of a pause may still correct what a step of loading has left.
  double error = at < top_of_pauses ? distance(paused.cauchy, before.cauchy) : 0;
  double largest = std::max(1e-3 * at_once.largest, specimen.least_stress());
  for (std::size_t mark = 0; mark < at_once.marks.size(); ++mark) {
    error = std::max(error, distance(at_once.marks[mark].cauchy, after_it.marks[mark].cauchy));
    largest = std::max(largest, deviator(at_once.marks[mark].cauchy).cwiseAbs().maxCoeff());
  }
  return error / largest;
}

/// Of a pause after loading, and after a little unloading in one step: what is kept of the largest load shows there,
/// and may be gone after some steps.
double trace_of_pauses(const Specimen& specimen, int steps) {
  constexpr double top = top_of_pauses, below = 0.28;
  const auto F = [&](double s) { return specimen.space.stretch(specimen.amplitude, s); };
  const Loading loading{[&](double t) { return F(top * t); }, 1};
  const Material& material = *specimen.material;
  const Point loaded = march(material, loading, {.steps = steps, .state = specimen.rest_state()}).marks[0];
  const Point unloaded = stepped(material, 1, 0.01, F(top), F(below), loaded.state);
  return std::max(trace_of_pause(specimen, steps, top, loaded), trace_of_pause(specimen, steps, below, unloaded));
}

void judge_pause(const Specimen& specimen, TestResult& result) {
  if (specimen.material->state_size() == 0) return;
  const double error =
      std::max(trace_of_pauses(specimen, specimen.steps()), trace_of_pauses(specimen, 4 * specimen.steps()));
  if (error <= converging_limit) return;
  result.measure = error;
  result.order = {};
  result.verdict = Verdict::fail;
  result.cause = causes::drifts;
  result.sentence = "a hundred steps without deformation change the stress of the next load by " + percent(error) +
                    " of the largest deviator";
}

}  // namespace

std::string drifting_variable(const Specimen& specimen) {
  constexpr double significant = 1e-4, few = 0.02;  // of the loading: what is carried along has not come to its end yet
  const Material& material = *specimen.material;
  const double length = specimen.rate_dependent() ? 1e-12 : 1;
  const Loading loading{[&](double t) { return specimen.space.stretch(specimen.amplitude, few * t); }, 1};
  const Tensor F = loading.F(1);
  const March loaded = march(material, loading, {.steps = 2, .state = specimen.rest_state()});
  std::vector<double> before = stepped(material, 1, length, F, F, loaded.marks[0].state).state;
  const std::vector<double> after = stepped(material, 1, length, F, F, before).state;
  const assay_material& table = material.table();
  std::size_t at = 0;
  for (std::uint32_t v = 0; v < table.state_count; ++v) {
    const auto size = static_cast<std::size_t>(components_of_kind(table.state[v].kind));
    double change = 0, largest = 0;
    for (std::size_t c = at; c < at + size; ++c) {
      change = std::max(change, std::abs(after[c] - before[c]));
      largest = std::max(largest, std::abs(before[c]));
    }
    if (table.state[v].kind != ASSAY_SCALAR && change > significant * largest) return table.state[v].name;
    at += size;
  }
  return {};
}

TestResult zero_increment(const Specimen& specimen) {
  TestResult result{.id = "zero_increment"};
  if (specimen.rate_dependent()) {
    result = no_time(specimen);
    try {
      if (result.verdict == Verdict::pass) judge_rate(specimen, result);
    } catch (const MaterialFailure&) {  // in steps of a length that it does not take
    }
    return result;
  }
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
  if (result.verdict == Verdict::pass) judge_pause(specimen, result);
  return result;
}

}  // namespace assay::check
