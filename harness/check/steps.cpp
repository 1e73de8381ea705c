// SPDX-License-Identifier: BSD-3-Clause
// What the length of the steps does to the result, and what the clock must not do.
#include <algorithm>
#include <cmath>

#include "harness/check/tests.hpp"

namespace assay::check {

namespace {

/// Stresses at the quarters of the way - one of them alone may agree with others by chance - over the largest deviator:
/// a pressure may be many times what flow and hardening bring.
std::vector<Tensor> relative_stresses(const Specimen& specimen, int steps) {
  constexpr int quarters = 4;
  constexpr double least = 0.02;  // of the largest stress
  const Loading way{[whole = stretch_to(specimen, 1).F](double t) { return whole(t / quarters); }, quarters};
  const March found = from_rest(specimen, way, steps / quarters, 1.0 / quarters);
  double scale = specimen.scale(least * found.largest);
  for (const Point& mark : found.marks) scale = std::max(scale, size_of(deviator(mark.cauchy)));
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
  const Tensor F = specimen.stretch(0.3);
  const Point now = hold_until(specimen, time, F, loaded, steps);
  return distance(now.cauchy, loaded.cauchy) / specimen.scale(size_of(loaded.cauchy));
}

/// What relaxes in few steps does so in many of the same time: one that shorter steps leave out is not found where all
/// are short enough.
void judge_held(const Specimen& specimen, TestResult& result) {
  constexpr double sudden = 1e-9, significant = 0.02, alike = 0.2, sound = 1.2;  // [s]; of the stress
  constexpr int few = 10, many = 300;
  try {
    const Tensor I = Tensor::Identity(), F = specimen.stretch(0.3);
    const Point loaded = stepped(specimen, 0, sudden, I, F, specimen.rest_state());
    for (const double time : {1e-2, 1.0, 100.0, 1e4}) {
      const double in_few = lost_while_held(specimen, loaded, time, few);
      if (in_few < significant || in_few > sound) continue;  // nothing, or steps too long for the law
      const double in_many = lost_while_held(specimen, loaded, time, many);
      if (in_many >= alike * in_few) continue;
      result = failed(causes::no_convergence, in_few - in_many, *result.threshold,
                      "held for " + rounded(time) + " s, a body loses " + percent(in_few) + " of its stress in " +
                          std::to_string(few) + " steps and " + percent(in_many) + " in " + std::to_string(many));
      return;
    }
  } catch (const MaterialFailure&) {  // of the length of a step
  }
}

}  // namespace

/// N, 2N, 4N, 8N steps along one path approach each other. Correct but first order in the step is no defect.
TestResult step_halving(const Specimen& specimen) {
  const Halvings found = halvings_of(specimen);
  const std::vector<double>& changes = found.changes;
  const double first = changes[changes.size() - 3], second = changes[changes.size() - 2], third = changes.back();
  TestResult result;
  if (third <= own_precision * own_precision) {
    result = passed(found.left(), found.most(), "the result does not depend on the number of steps");
  } else {
    const double order = std::log2(second / third);
    result = judged(found.left(), found.most(),
                    "halving the step changes the stress by " + rounded(second) + ", halving it again by " +
                        rounded(third) + (order < 1.5 ? ": correct, but first order in the step" : ""),
                    causes::no_convergence,
                    "halving the step again and again changes the stress by " + rounded(first) + ", " +
                        rounded(second) + ", " + rounded(third) + ": it does not converge");
    result.order = order;
  }
  if (result.verdict == Verdict::pass && specimen.rate_dependent()) judge_held(specimen, result);
  return result.verdict == Verdict::pass ? short_steps(specimen).value_or(std::move(result)) : result;
}

namespace {

constexpr double clock_limit = 1e-6;                            ///< t + dt rounds to 1e-10 s at 1e6 s
constexpr double lengths_of_steps[] = {1e-9, 1e-6, 1e-3, 1.0};  ///< [s]

/// A step of a body that was loaded in 1 s, to place s, in steps of a second's share; and the largest stress on the
/// way.
class LoadedStep {
 public:
  LoadedStep(const Specimen& specimen, double s, int steps)
      : material_(*specimen.material),
        usual_length_(1.0 / steps),
        F0_(stretch_to(specimen, s).F(1)),
        F1_(stretch_to(specimen, s).F(1 + usual_length_)),
        loaded_(from_rest(specimen, stretch_to(specimen, s), steps)) {}

  Tensor stress(double t, double length) const {
    return stepped(material_, t, length, F0_, F1_, loaded_.marks[0].state).cauchy;
  }
  Tensor stress(double t) const { return stress(t, usual_length_); }
  double largest() const { return loaded_.largest; }

 private:
  const Material& material_;
  double usual_length_;
  Tensor F0_, F1_;
  March loaded_;
};

bool step_length_matters(const Specimen& specimen, int steps) {
  const LoadedStep step(specimen, 0.2, steps);
  const auto matters = [&] {
    const Tensor usual = step.stress(1);
    return std::any_of(std::begin(lengths_of_steps), std::end(lengths_of_steps), [&](double dt) {
      return !(distance(step.stress(1, dt), usual) <= clock_limit * specimen.scale(step.largest()));
    });
  };
  return if_taken(matters, true);
}

}  // namespace

/// The result does not depend on the time of the day, nor that of a rate-independent model on the length of a step in
/// seconds: t from 0 and from 1e6 s, steps of 1e-9 to 1 s.
TestResult clock_independence(const Specimen& specimen) {
  const int steps = specimen.steps() / 2;
  double worst = 0;
  std::string sentence = "the result does not depend on the time";
  const auto note = [&](double error, const auto& words) {
    if (error <= worst && std::isfinite(error)) return;
    worst = std::isfinite(error) ? error : INFINITY;
    if (worst > clock_limit) sentence = words();
  };
  const auto whole_way = [&](double length, double begin) {
    return march(specimen, stretch_to(specimen, 1),
                 {.steps = steps, .phase_length = length, .begin = begin, .state = specimen.rest_state()});
  };
  const March usual = whole_way(1, 0);
  const double largest = specimen.scale(usual.largest);
  const auto compare = [&](double length, double begin, const std::string& words) {
    const auto error = [&] {
      return distance(whole_way(length, begin).marks[0].cauchy, usual.marks[0].cauchy) / largest;
    };
    note(if_taken(error, INFINITY), [&] {
      return words + (std::isfinite(worst) ? " changes the stress by " + rounded(worst) + " of itself"
                                           : " is refused, or makes a stress that is no number");
    });
  };
  compare(1, 1e6, "a time that begins at 1e6 s");
  if (!specimen.rate_dependent()) {
    const bool of_steps = step_length_matters(specimen, steps);
    for (const double dt : lengths_of_steps) {
      compare(dt * steps, 0,
              of_steps ? "a step of " + rounded(dt) + " s, of a model that does not declare " +
                             specimen.options.declarations.rate_dependence + ","
                       : "a history in steps of " + rounded(dt) +
                             " s, though no step of a loaded body depends on its length: the time since the beginning");
    }
  }
  for (const double s : {0.2, 0.6}) {  // from a loaded state, whose clock may have been set to anything
    const LoadedStep step(specimen, s, steps);
    const Tensor at_1_s = step.stress(1);
    for (const double t : {0.0, 1e-7, 1e6}) {
      note(distance(step.stress(t), at_1_s) / largest, [&] {
        return "the same step of a loaded body at t = " + rounded(t) + " s and at 1 s differs by " + rounded(worst) +
               " of the stress";
      });
    }
  }
  return judged(worst, clock_limit, sentence, causes::clock, sentence);
}

}  // namespace assay::check
