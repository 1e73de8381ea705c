// SPDX-License-Identifier: BSD-3-Clause
// What must hold without any comparison: where nothing is deformed, or nothing more, nothing happens.
#include <algorithm>
#include <cmath>

#include "harness/check/tests.hpp"
#include "harness/material/state_variable.hpp"

namespace assay::check {

/// F = I leaves no stress.
TestResult stress_at_rest(const Specimen& specimen) {
  constexpr double most = 1e-6;  // of the modulus: single precision leaves 1e-7
  const Tensor I = Tensor::Identity();
  const Point rest = hold(specimen, 0, 1, I, {{}, specimen.rest_state()}), later = hold(specimen, 1, 1, I, rest);
  hold(specimen, 2, 1, I, later);  // a stress of zero divides nothing
  const double measure = distance(rest.cauchy, -specimen.rest_pressure() * I) / specimen.modulus;
  const std::string words = "stress of the undeformed body, relative to the modulus: " + rounded(measure);
  TestResult result = judged(measure, most, words, causes::stress_at_rest, words);
  if (specimen.own_pressure > 0) {
    result.sentence = std::string(remark_words) + "the material has a pressure at rest, " +
                      rounded(specimen.own_pressure) + " Pa, which free faces cannot balance";
  }
  if (measure <= most || specimen.pressure == 0) return result;
  const bool goes_on = distance(later.cauchy, rest.cauchy) > most * specimen.modulus;
  return failed(goes_on && !specimen.rate_dependent() ? causes::drifts : causes::initial_stress, measure, most,
                "a step without deformation changes the pressure at which a body is at rest, by " + rounded(measure) +
                    " of the modulus" + (goes_on ? ", and the next one changes it again" : ""));
}

bool pressed_at_rest(const Specimen& specimen) {
  const Tensor stress = stress_at_once(specimen, Tensor::Identity());
  return distance(deviator(stress), Tensor::Zero()) <= own_precision * size_of(stress);
}

bool grows_at_rest(const Specimen& specimen) {
  constexpr double significant = 1e-6, none = 1e-3, alike = 0.1, brief = 1e-6;  // of the modulus, of it, of it; [s]
  const Tensor I = Tensor::Identity();
  const auto stress_after = [&](double time, int steps) {
    const Point found = hold_until(specimen, time, I, {{}, specimen.rest_state()}, steps);
    return Tensor(found.cauchy + specimen.rest_pressure() * I);
  };
  const auto grows = [&] {
    const Tensor whole = stress_after(1, 1), parts = stress_after(1, 10);
    const double size = size_of(whole);
    return size > significant * specimen.modulus && size_of(stress_after(brief, 1)) < none * size &&
           distance(whole, parts) < alike * size;
  };
  return if_taken(grows, false);
}

namespace {

constexpr double top_of_pauses = 0.3;  ///< of the stretch

/// What steps without deformation change whose length goes to zero: a model that relaxes does so in time. A first one
/// takes away what depends on the rate of deformation.
TestResult no_time(const Specimen& specimen) {
  constexpr int repeats = 31;  // odd: what goes to and fro does not come back
  const Loading loading = stretch_to(specimen, top_of_pauses);
  const March loaded = from_rest(specimen, loading);
  double least = INFINITY;
  for (const double length : {1e-6, 1e-9, 1e-12}) {
    const Point first = hold(specimen, 1, length, loading.F(1), loaded.marks[0]);
    const Point last = hold(specimen, 1, length, loading.F(1), first, repeats);
    least = std::min(least, distance(last.cauchy, first.cauchy) / specimen.scale(loaded.largest));
  }
  const std::string words = "31 steps without deformation, and in no time, change the stress by " + rounded(least);
  return judged(least, converging_limit, words, causes::drifts,
                words + " of the largest stress: the relaxation follows the number of steps, not the time");
}

/// What a step brings and the next one, without deformation, takes away.
double taken_away(const Specimen& specimen, const Point& from, double strain, double length) {
  const Tensor F0 = specimen.stretch(top_of_pauses);
  const Tensor F1 = specimen.stretch(top_of_pauses + strain);
  const Point moved = stepped(specimen, 1, length, F0, F1, from.state);
  return distance(moved.cauchy, hold(specimen, 1 + length, length, F1, moved).cauchy);
}

/// A stress of the rate of deformation is one of strain over time. One that comes with each step, the more the larger
/// its strain and however short it is, and is gone with the next, vanishes as steps become short.
void judge_rate(const Specimen& specimen, TestResult& result) {
  constexpr double strain = 0.02, same = 1e-6, significant = 1e-3;
  const March loaded = from_rest(specimen, stretch_to(specimen, top_of_pauses));
  const auto taken = [&](double of_strain, double length) {
    return taken_away(specimen, loaded.marks[0], of_strain, length);
  };
  const double usual = taken(strain, 1e-4);
  if (!(usual > significant * strain * specimen.amplitude * specimen.modulus)) return;
  if (!(std::abs(taken(strain, 1e-6) - usual) <= same * usual)) return;  // longer ones may be told from these
  const double share = taken(0.5 * strain, 1e-4) / usual;
  if (!(share < 0.97)) return;  // a stress of the direction of the rate alone
  result = failed(causes::drifts, usual / specimen.scale(loaded.largest), converging_limit,
                  "a step without deformation removes the stress of the step before it, however short both are: the "
                  "stress follows the step, not the rate");
}

/// What many steps without deformation in the middle of a loading leave in the stress that follows, over the largest
/// deviator: a pressure may be many times what flow and hardening bring.
double trace_of_pause(const Specimen& specimen, int steps, double at, const Point& before) {
  constexpr int pause = 101;  // odd
  // What is forgotten in a pause may show in unloading alone, come back soon or show late: the ends are compared.
  const double ends[] = {at, 0.25, 0.32, 0.4, 1};
  const double a = specimen.amplitude;
  const Loading then{[&](double t) {
                       const int k = std::min(3, static_cast<int>(t));
                       return specimen.space.stretch(a, ends[k] + (t - k) * (ends[k + 1] - ends[k]));
                     },
                     4};
  const Point paused = hold(specimen, 1, 0.01, then.F(0), before, pause);
  const March at_once = march(specimen, then, {.steps = steps / 2, .begin = 1, .state = before.state});
  const March after_it = march(specimen, then, {.steps = steps / 2, .begin = 1, .state = paused.state});
  // The first step of a pause may still correct what a step of loading has left.
  double error = at < top_of_pauses ? distance(paused.cauchy, before.cauchy) : 0;
  double largest = std::max(1e-3 * at_once.largest, specimen.least_stress());
  for (std::size_t mark = 0; mark < at_once.marks.size(); ++mark) {
    error = std::max(error, distance(at_once.marks[mark].cauchy, after_it.marks[mark].cauchy));
    largest = std::max(largest, size_of(deviator(at_once.marks[mark].cauchy)));
  }
  return error / largest;
}

/// Of a pause after loading, and after a little unloading in one step: what is kept of the largest load shows there,
/// and may be gone after some steps.
double trace_of_pauses(const Specimen& specimen, int steps) {
  constexpr double top = top_of_pauses, below = 0.28;
  const Point loaded = from_rest(specimen, stretch_to(specimen, top), steps).marks[0];
  const Point unloaded = stepped(specimen, 1, 0.01, specimen.stretch(top), specimen.stretch(below), loaded.state);
  return std::max(trace_of_pause(specimen, steps, top, loaded), trace_of_pause(specimen, steps, below, unloaded));
}

void judge_pause(const Specimen& specimen, TestResult& result) {
  if (specimen.material->state_size() == 0) return;
  const double error =
      std::max(trace_of_pauses(specimen, specimen.steps()), trace_of_pauses(specimen, 4 * specimen.steps()));
  if (error <= converging_limit) return;
  result = failed(causes::drifts, error, converging_limit,
                  "a hundred steps without deformation change the stress of the next load by " + percent(error) +
                      " of the largest deviator");
}

}  // namespace

std::string drifting_variable(const Specimen& specimen) {
  constexpr double significant = 1e-4, few = 0.02;  // of the loading: what is carried along has not come to its end yet
  const double length = specimen.rate_dependent() ? 1e-12 : 1;
  const Loading loading = stretch_to(specimen, few);
  const Point before = hold(specimen, 1, length, loading.F(1), from_rest(specimen, loading, 2).marks[0]);
  const Point after = hold(specimen, 1, length, loading.F(1), before);
  for (const StatePlace& place : state_of(specimen.material->table())) {
    const Variable was = place.in(before.state), is = place.in(after.state);
    if (place.kind != ASSAY_SCALAR && is.distance(was) > significant * was.largest()) return place.name;
  }
  return {};
}

/// Steps with F1 = F0 after loading change neither stress nor state of a rate-independent model; of another one, in
/// the limit of no time.
TestResult zero_increment(const Specimen& specimen) {
  if (specimen.rate_dependent()) {
    TestResult result = no_time(specimen);
    try {
      if (result.verdict == Verdict::pass) judge_rate(specimen, result);
    } catch (const MaterialFailure&) {  // in steps of a length that it does not take
    }
    return result;
  }
  const Loading loading = stretch_to(specimen, top_of_pauses);
  const Errors errors = at_halved_steps(specimen.steps(), [&](int steps) {
    const March loaded = from_rest(specimen, loading, steps);
    const Point later = hold(specimen, 1, 0.01, loading.F(1), loaded.marks[0], 3);
    return distance(later.cauchy, loaded.marks[0].cauchy) / specimen.scale(loaded.largest);
  });
  TestResult result = judged(errors, "three steps without deformation", specimen.steps());
  if (result.verdict == Verdict::fail) result.cause = causes::drifts;
  if (result.verdict == Verdict::pass) judge_pause(specimen, result);
  return result;
}

}  // namespace assay::check
