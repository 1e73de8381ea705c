// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/steps.hpp"

#include <algorithm>
#include <cmath>

#include "harness/check/judge.hpp"

namespace assay::check {

namespace {

Loading whole_way(const Specimen& specimen) {
  return {[a = specimen.amplitude](double t) { return stretch(a, t); }, 1};
}

Tensor stress_after(const Specimen& specimen, int steps, double length, double begin, double& largest) {
  const Material& material = *specimen.material;
  const March found = march(material, whole_way(specimen),
                            {.steps = steps, .phase_length = length, .begin = begin, .state = specimen.rest_state()});
  largest = std::max(found.largest, specimen.least_stress());
  return found.marks[0].cauchy;
}

}  // namespace

TestResult continuity(const Specimen& specimen) {
  constexpr double most = 1e-4, per_change = 1e3;
  const Material& material = *specimen.material;
  const std::vector<double> rest = specimen.rest_state();
  TestResult result{.id = "continuity", .threshold = most};
  double worst = 0, at = 0;
  for (const double s : {0.11, 0.23, 0.37}) {
    const Tensor F = turn(s) * stretch(specimen.amplitude, s);
    const auto stress = [&](const Tensor& end) {
      return stepped(material, 0, 1, Tensor::Identity(), end, rest).cauchy;
    };
    const Tensor expected = stress(F);
    for (const double change : {1e-14, 1e-12, 1e-10, 1e-8}) {
      const Tensor moved = stress(F + change * stretch(1, s));
      const double error =
          distance(moved, expected) / std::max(expected.cwiseAbs().maxCoeff(), specimen.least_stress());
      const double excess = error - per_change * change / specimen.amplitude;
      if (!(excess <= worst)) worst = std::isfinite(excess) ? excess : INFINITY, at = change;
    }
  }
  result.measure = worst;
  result.verdict = worst <= most ? Verdict::pass : Verdict::fail;
  if (result.verdict == Verdict::fail) result.cause = causes::no_convergence;
  result.sentence = worst <= most ? "the stress follows F without jumps"
                                  : "a change of F by " + rounded(at) + " changes the stress by " + rounded(worst) +
                                        " of itself: it is no continuous function of F";
  return result;
}

TestResult step_halving(const Specimen& specimen) {
  constexpr double apart = 5e-2, no_better = 0.9;
  std::array<Tensor, 4> stress;
  double largest = 0;
  for (int k = 0; k < 4; ++k) {
    stress[static_cast<std::size_t>(k)] = stress_after(specimen, specimen.steps() << k, 1, 0, largest);
  }
  const auto change = [&](std::size_t k) { return distance(stress[k], stress[k + 1]) / largest; };
  const double first = change(0), second = change(1), third = change(2);
  TestResult result{.id = "step_halving", .measure = third, .threshold = apart};
  if (third <= own_precision * own_precision) {
    result.sentence = "the result does not depend on the number of steps";
    return result;
  }
  result.order = std::log2(second / third);
  result.verdict = third > apart && third > no_better * std::max(first, second) ? Verdict::fail : Verdict::pass;
  result.sentence = "halving the step changes the stress by " + rounded(second) + ", halving it again by " +
                    rounded(third) + (*result.order < 1.5 ? ": correct, but first order in the step" : "");
  if (result.verdict == Verdict::pass) return result;
  result.cause = causes::no_convergence;
  result.sentence = "halving the step again and again changes the stress by " + rounded(first) + ", " +
                    rounded(second) + ", " + rounded(third) + ": it has no limit";
  return result;
}

TestResult clock_independence(const Specimen& specimen) {
  constexpr double most = 1e-6;  // t + dt rounds to 1e-10 s at 1e6 s
  const int steps = specimen.steps() / 2;
  double largest = 0, worst = 0;
  std::string sentence = "the clock changes nothing";
  const auto compare = [&](double length, double begin, const Tensor& expected, const std::string& words) {
    double ignored = 0;
    const double error = distance(stress_after(specimen, steps, length, begin, ignored), expected) / largest;
    if (error <= worst && std::isfinite(error)) return;
    worst = std::isfinite(error) ? error : INFINITY;
    if (worst > most) sentence = words + " changes the stress by " + rounded(worst) + " of itself";
  };
  const Tensor expected = stress_after(specimen, steps, 1, 0, largest);
  compare(1, 1e6, expected, "a clock that begins at 1e6 s");
  if (!specimen.rate_dependent()) {
    for (const double dt : {1e-9, 1e-6, 1e-3, 1.0}) {
      compare(dt * steps, 0, expected, "a step of " + rounded(dt) + " s, of a model that declares no rate dependence,");
    }
  }
  for (const double s : {0.2, 0.6}) {  // from a loaded state, whose clock may have been set to anything
    const Loading loading = {[&](double t) { return stretch(specimen.amplitude, s * t); }, 1};
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
