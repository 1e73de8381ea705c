// SPDX-License-Identifier: BSD-3-Clause
// Whether work comes out of a material: against its energy, in cycles, while it is held.
#include <algorithm>
#include <cmath>
#include <utility>

#include "harness/check/specimen.hpp"
#include "harness/check/tests.hpp"
#include "harness/check/work.hpp"
#include "harness/numeric/norms.hpp"

namespace assay::check {

namespace {

/// The most that comes back of what was lost, over the work: what is stored is known.
double out_of_what_was_lost(const Specimen& specimen, const Offer<assay_energy>& form) {
  const int steps = 4 * specimen.steps();
  Work work(specimen, 1.0 / steps);
  const double stored_at_rest = stored_energy(form, Tensor::Identity(), work.state());
  double lost = 0, peak = 0, worst = 0;
  for (int k = 0; k < steps; ++k) {
    const Tensor F = specimen.stretch((k + 1.0) / steps);
    work.step(F);
    lost = work.done() - (stored_energy(form, F, work.state()) - stored_at_rest);
    peak = std::max(peak, lost);
    worst = std::max(worst, peak - lost);
  }
  const bool known = std::isfinite(lost);  // what is refused, or no number, the test of the energy tells
  return known ? share_of_work(specimen, worst, work) : 0;
}

/// From rest, where nothing is stored, out and back the same way in a time [s]: the most that comes out of it at any
/// instant, over the work. What a law without memory gives on its way out it takes on its way back.
double out_of_rest(const Specimen& specimen, int steps, double time) {
  Work work(specimen, 0.5 * time / steps);
  double least = 0;
  for (int k = 1; k <= 2 * steps; ++k) {
    const double there = 1 - std::abs(1 - static_cast<double>(k) / steps);
    work.step(specimen.stretch(0.4 * there));
    if (k == 2 * steps || !specimen.material->path_independent()) least = std::min(least, work.done());
  }
  const double share = share_of_work(specimen, -least, work);
  return std::isfinite(share) ? share : INFINITY;
}

/// As `out_of_rest`, of a change of volume alone, out and back to either side: other strains hide that a body swells
/// where it is pressed, as they take more work than that gives. What comes out on the way counts in the first step, as
/// rest is no rest then; later it may be given back.
double out_of_volume(const Specimen& specimen, int steps, double time) {
  constexpr double least_stiffness = 1e-3;  // of the modulus: what has less against pressure does little work there
  const double largest = 0.4 * specimen.amplitude;
  Work work(specimen, 0.25 * time / steps);
  double worst = 0, done_at_rest = 0;
  const auto note = [&](double out, double paid, double strain) {
    const double share = out / std::max(paid, least_stiffness * specimen.modulus * strain * strain);
    worst = std::max(worst, std::isfinite(share) ? share : INFINITY);
  };
  for (int k = 1; k <= 4 * steps; ++k) {
    const double saw = 1 - std::abs(std::remainder(static_cast<double>(k) / steps + 1, 4));  // 0, -1, 0, 1, 0
    try {
      work.step((1 + largest * saw) * Tensor::Identity());
    } catch (const MaterialFailure&) {  // what it stands counts
      break;
    }
    const double out = done_at_rest - work.done();
    if (k % (2 * steps) == 1) note(out, std::abs(out), largest / steps);
    if (k % (2 * steps) == 0) done_at_rest = work.done(), note(-done_at_rest, work.paid(), largest);
  }
  return worst;
}

/// By how much the deviator of a body that is held grows after it has been less, over the largest of it, from a time
/// [s] to 1e8 s in so many steps a decade.
double growth_while_held(const Specimen& specimen, double from, int a_decade) {
  const double ratio = std::pow(10.0, 1.0 / a_decade);
  const Tensor F = specimen.stretch(0.3);
  double t = from, least = INFINITY, largest = 0, growth = 0;
  Point now = stepped(specimen, 0, t, Tensor::Identity(), F, specimen.rest_state());
  while (t < 1e8) {
    const double dt = (ratio - 1) * t;
    now = stepped(specimen, t, dt, F, F, now.state);
    t += dt;
    const double size = stable_norm(deviator(now.cauchy));
    least = std::min(least, size), largest = std::max(largest, size);
    growth = std::max(growth, size - least);
  }
  return growth / specimen.scale(largest);
}

/// A part that relaxes the wrong way may hide among others that lose more, but not while nothing else moves.
void judge_relaxation(const Specimen& specimen, double from, TestResult& result) {
  constexpr double most = 0.01, same = 0.3;
  try {
    const double coarse = growth_while_held(specimen, from, 8);
    if (coarse <= most) return;
    const double fine = growth_while_held(specimen, from, 24);
    if (fine <= most || std::abs(fine - coarse) > same * coarse) return;  // of the steps, not of the model
    result = failed(causes::dissipation, fine, most,
                    "at constant strain the stress grows with time, by " + percent(fine) +
                        ": a part of it relaxes in the wrong direction");
  } catch (const MaterialFailure&) {  // of the length of a step
  }
}

/// The most by which the largest stress of a cycle grows while the number of cycles between the same strains doubles,
/// in twenty or as many as the material stands. Hardening that goes with the path doubles it at most; where flow feeds
/// what drives it, it grows as an exponential does.
double growth_in_cycles(const Specimen& specimen) {
  constexpr std::size_t cycles = 20, steps = 80;  // and of each cycle
  Work work(specimen, 1.0 / steps);
  std::vector<double> largest(1, specimen.least_stress());
  try {
    for (std::size_t k = 1; k <= cycles * steps; ++k) {
      const double saw = std::abs(std::remainder(4.0 * static_cast<double>(k) / steps - 1, 4));
      work.step(specimen.space.stretch(0.5 * specimen.amplitude, 1 - saw));
      largest.back() = std::max(largest.back(), work.largest());
      if (k % steps == 0) largest.push_back(specimen.least_stress());
    }
  } catch (const MaterialFailure&) {  // it may stand no more than a few cycles
  }
  double growth = 1;
  for (std::size_t k = 1; 2 * k <= largest.size(); ++k) growth = std::max(growth, largest[2 * k - 1] / largest[k - 1]);
  return growth;
}

void judge_cycles(const Specimen& specimen, TestResult& result) {
  constexpr double most = 10;
  const double growth = growth_in_cycles(specimen);
  if (growth <= most) return;
  result = failed(causes::dissipation, growth, most,
                  "in strain cycles of constant amplitude the stress grows without bound, " + rounded(growth) +
                      " times when the number of cycles doubles: plastic flow increases the stress that drives it");
}

/// Of what depends on the rate. What fails in steps too brief for 24 bits, and not in longer ones, is no matter of
/// work.
void judge_rates(const Specimen& specimen, TestResult& result) {
  constexpr double brief = 1e-9, longer = 1e-4;  // [s]
  const auto judge = [&](double sudden, TestResult& of) {
    judge_relaxation(specimen, 10 * sudden, of);
    if (of.verdict == Verdict::pass) of = long_steps(specimen, sudden).value_or(std::move(of));
  };
  TestResult in_longer = result;
  judge(brief, result);
  if (result.verdict == Verdict::pass || !is_of_single_precision(specimen)) return;
  judge(longer, in_longer);
  if (in_longer.verdict != Verdict::pass) return;
  result.cause = causes::single_precision;
  result.sentence =
      "the stress has the 24 bits of single precision, which are too few in brief steps: it fails in steps "
      "of " +
      rounded(brief) + " s, and is right in steps of " + rounded(longer) +
      " s. One variable or constant of 4 bytes is enough";
}

/// Unloading of what has yielded is elastic, or loses work.
void judge_unloading(const Specimen& specimen, TestResult& result) {
  constexpr double most =
      0.05;  // of plasticity without a potential, of damage and of steps of finite length below 0.01
  const double worst = out_of_a_cycle_after_yield(specimen).value_or(0);
  if (worst <= most) return;
  result = failed(causes::dissipation, worst, most,
                  "after yield, a strain cycle that reverses the load and returns gains " + percent(worst) +
                      " of the work of continued loading: unloading reverses the plastic flow");
}

TestResult judged_work(double worst, double most, const std::string& words) {
  return judged(worst, most, "work is stored or dissipated, and no energy is created", causes::dissipation,
                "energy is created: " + percent(worst) + " of the work" + words);
}

/// The most that comes out of a history, of those that take these times [s], by the finer of two steps.
double most_in(const std::vector<double>& times, const Specimen& specimen,
               double (*out_of)(const Specimen&, int steps, double time)) {
  double worst = 0;
  for (const double time : times) {
    const int steps = specimen.steps();
    try {
      const double coarse = out_of(specimen, steps, time);
      if (coarse > worst) worst = std::max(worst, std::min(coarse, out_of(specimen, 2 * steps, time)));
    } catch (const MaterialFailure&) {
      if (time == times.front()) throw;  // what was loaded in 1 s before need not stand a thousandth or a thousand
    }
  }
  return worst;
}

}  // namespace

/// The work done on the material is stored or dissipated, never made: against its energy along a path out, back and
/// beyond; and, of any model, from rest out and back no more comes out than was put in.
TestResult dissipation(const Specimen& specimen) {
  constexpr double of_energy = 1e-3;   // what steps of finite length leave
  constexpr double of_history = 0.02;  // what steps of finite length leave is below a thousandth
  const Offer<assay_energy> form(*specimen.material);
  if (form) {
    TestResult result = judged_work(out_of_what_was_lost(specimen, form), of_energy, "");
    if (result.verdict == Verdict::fail) return result;
  }
  if (specimen.rest_pressure() > 0) {
    return form ? TestResult{.sentence = "no dissipated work is recovered"}
                : left_out("the model offers no energy, and stores some at rest: under pressure");
  }
  const auto times = specimen.rate_dependent() ? std::vector{1.0, 1e-3, 1e3} : std::vector{1.0};
  const double stretched = most_in(times, specimen, out_of_rest);
  const double pressed = most_in(times, specimen, out_of_volume);
  const bool of_volume = stretched <= of_history && pressed > of_history;
  TestResult result = judged_work(std::max(stretched, pressed), of_history,
                                  of_volume ? ": in a change of volume from rest and back" : ": from rest and back");
  if (result.verdict == Verdict::pass) judge_potential(specimen, times, result);
  if (result.verdict == Verdict::pass) result = viscosity(specimen, times).value_or(std::move(result));
  if (result.verdict != Verdict::pass) return result;
  if (specimen.rate_dependent()) {
    judge_rates(specimen, result);
  } else {
    judge_cycles(specimen, result);
  }
  if (result.verdict == Verdict::pass) judge_unloading(specimen, result);
  return result;
}

}  // namespace assay::check
