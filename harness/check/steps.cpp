// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/steps.hpp"

#include <algorithm>
#include <cmath>

#include "harness/check/judge.hpp"
#include "harness/check/short_steps.hpp"

namespace assay::check {

namespace {

Loading whole_way(const Specimen& specimen) {
  return {[a = specimen.amplitude, space = specimen.space](double t) { return space.stretch(a, t); }, 1};
}

Tensor stress_after(const Specimen& specimen, int steps, double length, double begin, double& largest) {
  const Material& material = *specimen.material;
  const March found = march(material, whole_way(specimen),
                            {.steps = steps, .phase_length = length, .begin = begin, .state = specimen.rest_state()});
  largest = std::max(found.largest, specimen.least_stress());
  return found.marks[0].cauchy;
}

}  // namespace

namespace {

/// Stresses at the quarters of the way - one of them alone may agree with others by chance - over the largest deviator:
/// a pressure may be many times what flow and hardening bring.
std::vector<Tensor> relative_stresses(const Specimen& specimen, int steps) {
  constexpr int quarters = 4;
  constexpr double least = 0.02;  // of the largest stress
  const Loading way{[whole = whole_way(specimen).F](double t) { return whole(t / quarters); }, quarters};
  const March found =
      march(*specimen.material, way,
            {.steps = steps / quarters, .phase_length = 1.0 / quarters, .state = specimen.rest_state()});
  double scale = std::max(least * found.largest, specimen.least_stress());
  for (const Point& mark : found.marks) scale = std::max(scale, deviator(mark.cauchy).cwiseAbs().maxCoeff());
  std::vector<Tensor> stresses;
  for (const Point& mark : found.marks) stresses.push_back(mark.cauchy / scale);
  return stresses;
}

/// What the halvings of a step change, each of them.
struct Halvings {
  std::vector<double> changes;

  double left() const { return std::max(changes.back(), changes[changes.size() - 2]); }
  /// Of `left`: little, or much less than at first. What jumps to and fro agrees by chance now and then, and not twice
  /// at four places.
  double most() const {
    constexpr double small = 2e-3, falls = 0.25, apart = 5e-2;
    return std::max(small, std::min(apart, falls * std::max(changes[0], changes[1])));
  }
  bool have_limit() const { return left() <= most(); }
  bool leave_no_doubt() const { return left() <= 0.2 * most(); }
};

Halvings halvings_of(const Specimen& specimen) {
  constexpr std::size_t least = 3, most = 8;  // more where a fast process is not yet resolved
  Halvings found;
  std::vector<Tensor> before = relative_stresses(specimen, specimen.steps());
  while (found.changes.size() < least || (found.changes.size() < most && !found.leave_no_doubt())) {
    const std::vector<Tensor> now = relative_stresses(specimen, specimen.steps() << (found.changes.size() + 1));
    double change = 0;
    for (std::size_t k = 0; k < now.size(); ++k) change = std::max(change, distance(before[k], now[k]));
    found.changes.push_back(change);
    before = now;
  }
  return found;
}

/// What a body that is held for a time [s] after a sudden load loses of its stress, over that.
double lost_while_held(const Specimen& specimen, const Point& loaded, double time, int steps) {
  const Tensor F = specimen.space.stretch(specimen.amplitude, 0.3);
  Point now = loaded;
  for (int k = 0; k < steps; ++k) {
    now = stepped(*specimen.material, time * k / steps, time / steps, F, F, now.state);
  }
  const double scale = std::max(loaded.cauchy.cwiseAbs().maxCoeff(), specimen.least_stress());
  return distance(now.cauchy, loaded.cauchy) / scale;
}

/// What relaxes in few steps does so in many of the same time: one that shorter steps leave out is not found where all
/// are short enough.
void judge_held(const Specimen& specimen, TestResult& result) {
  constexpr double sudden = 1e-9, significant = 0.02, alike = 0.2, sound = 1.2;  // [s]; of the stress
  constexpr int few = 10, many = 300;
  try {
    const Tensor I = Tensor::Identity(), F = specimen.space.stretch(specimen.amplitude, 0.3);
    const Point loaded = stepped(*specimen.material, 0, sudden, I, F, specimen.rest_state());
    for (const double time : {1e-2, 1.0, 100.0, 1e4}) {
      const double in_few = lost_while_held(specimen, loaded, time, few);
      if (in_few < significant || in_few > sound) continue;  // nothing, or steps too long for the law
      const double in_many = lost_while_held(specimen, loaded, time, many);
      if (in_many >= alike * in_few) continue;
      result.verdict = Verdict::fail;
      result.measure = in_few - in_many;
      result.order = {};
      result.cause = causes::no_convergence;
      result.sentence = "held for " + rounded(time) + " s, a body loses " + percent(in_few) + " of its stress in " +
                        std::to_string(few) + " steps and " + percent(in_many) + " in " + std::to_string(many);
      return;
    }
  } catch (const MaterialFailure&) {  // of the length of a step
  }
}

}  // namespace

TestResult step_halving(const Specimen& specimen) {
  const Halvings found = halvings_of(specimen);
  const std::vector<double>& changes = found.changes;
  const double first = changes[changes.size() - 3], second = changes[changes.size() - 2], third = changes.back();
  TestResult result{.id = "step_halving", .measure = found.left(), .threshold = found.most()};
  if (third <= own_precision * own_precision) {
    result.sentence = "the result does not depend on the number of steps";
    if (specimen.rate_dependent()) judge_held(specimen, result);
    return result.verdict == Verdict::pass ? short_steps(specimen).value_or(std::move(result)) : result;
  }
  result.order = std::log2(second / third);
  result.verdict = found.have_limit() ? Verdict::pass : Verdict::fail;
  result.sentence = "halving the step changes the stress by " + rounded(second) + ", halving it again by " +
                    rounded(third) + (*result.order < 1.5 ? ": correct, but first order in the step" : "");
  if (result.verdict == Verdict::pass && specimen.rate_dependent()) judge_held(specimen, result);
  if (result.verdict == Verdict::pass) {
    if (auto left_out = short_steps(specimen)) return *left_out;
  }
  if (result.verdict == Verdict::pass || result.cause == causes::no_convergence) return result;
  result.cause = causes::no_convergence;
  result.sentence = "halving the step again and again changes the stress by " + rounded(first) + ", " +
                    rounded(second) + ", " + rounded(third) + ": it does not converge";
  return result;
}

namespace {

constexpr double clock_limit = 1e-6;                            ///< t + dt rounds to 1e-10 s at 1e6 s
constexpr double lengths_of_steps[] = {1e-9, 1e-6, 1e-3, 1.0};  ///< [s]

/// Of a body that was loaded in 1 s.
bool step_length_matters(const Specimen& specimen, int steps) {
  const Loading loading = {[&](double t) { return specimen.space.stretch(specimen.amplitude, 0.2 * t); }, 1};
  const March loaded = march(*specimen.material, loading, {.steps = steps, .state = specimen.rest_state()});
  const Tensor F0 = loading.F(1), F1 = loading.F(1 + 1.0 / steps);
  const auto stress = [&](double dt) {
    return stepped(*specimen.material, 1, dt, F0, F1, loaded.marks[0].state).cauchy;
  };
  try {
    const Tensor usual = stress(1.0 / steps);
    const double scale = std::max(loaded.largest, specimen.least_stress());
    return std::any_of(std::begin(lengths_of_steps), std::end(lengths_of_steps),
                       [&](double dt) { return !(distance(stress(dt), usual) <= clock_limit * scale); });
  } catch (const MaterialFailure&) {
    return true;
  }
}

}  // namespace

TestResult clock_independence(const Specimen& specimen) {
  constexpr double most = clock_limit;
  const int steps = specimen.steps() / 2;
  double largest = 0, worst = 0;
  std::string sentence = "the result does not depend on the time";
  const auto compare = [&](double length, double begin, const Tensor& expected, const std::string& words) {
    double ignored = 0, error = INFINITY;
    try {
      error = distance(stress_after(specimen, steps, length, begin, ignored), expected) / largest;
    } catch (const MaterialFailure&) {  // where the usual clock has no such thing
    }
    if (error <= worst && std::isfinite(error)) return;
    worst = std::isfinite(error) ? error : INFINITY;
    if (worst > most) {
      sentence = words + (std::isfinite(worst) ? " changes the stress by " + rounded(worst) + " of itself"
                                               : " is refused, or makes a stress that is no number");
    }
  };
  const Tensor expected = stress_after(specimen, steps, 1, 0, largest);
  compare(1, 1e6, expected, "a time that begins at 1e6 s");
  if (!specimen.rate_dependent()) {
    const bool of_steps = step_length_matters(specimen, steps);
    for (const double dt : lengths_of_steps) {
      compare(dt * steps, 0, expected,
              of_steps ? "a step of " + rounded(dt) + " s, of a model that does not declare " +
                             specimen.options.declarations.rate_dependence + ","
                       : "a history in steps of " + rounded(dt) +
                             " s, though no step of a loaded body depends on its length: the time since the beginning");
    }
  }
  for (const double s : {0.2, 0.6}) {  // from a loaded state, whose clock may have been set to anything
    const Loading loading = {[&](double t) { return specimen.space.stretch(specimen.amplitude, s * t); }, 1};
    const March loaded = march(*specimen.material, loading, {.steps = steps, .state = specimen.rest_state()});
    const Tensor F0 = loading.F(1), F1 = loading.F(1 + 1.0 / steps);
    const auto at = [&](double t) {
      return stepped(*specimen.material, t, 1.0 / steps, F0, F1, loaded.marks[0].state).cauchy;
    };
    const Tensor usual = at(1);
    for (const double t : {0.0, 1e-7, 1e6}) {
      const double error = distance(at(t), usual) / largest;
      if (error <= worst && std::isfinite(error)) continue;
      worst = std::isfinite(error) ? error : INFINITY;
      if (worst > most) {
        sentence = "the same step of a loaded body at t = " + rounded(t) + " s and at 1 s differs by " +
                   rounded(worst) + " of the stress";
      }
    }
  }
  TestResult result{.id = "clock", .measure = worst, .threshold = most};
  result.verdict = worst <= most ? Verdict::pass : Verdict::fail;
  if (result.verdict == Verdict::fail) result.cause = causes::clock;
  result.sentence = sentence;
  return result;
}

}  // namespace assay::check
