// SPDX-License-Identifier: BSD-3-Clause
// Steps that are longer than the times in which a material relaxes.
#include <algorithm>
#include <cmath>
#include <vector>

#include "harness/check/judge.hpp"
#include "harness/check/work.hpp"
#include "harness/numeric/norms.hpp"

namespace assay::check {

namespace {

constexpr double most_moved = 3, most_held = 2;                                  ///< times the stress of a sudden step
constexpr double lengths[] = {1e-3, 1e-2, 0.1, 1, 10, 1e2, 1e3, 1e4, 1e5, 1e6};  ///< [s]

/// A stretch, and the point to which a sudden step brings it.
class Struck {
 public:
  Struck(const Specimen& specimen, double sudden)
      : specimen_(specimen),
        sudden_(sudden),
        F_(specimen.stretch(0.3)),
        rest_(specimen.rest_state()),
        point_(stepped(specimen, 0, sudden, I_, F_, rest_)) {}

  /// Of the stress of the sudden step: that of a long one [s].
  double moved(double length) const { return times(above_rest(stress_at_once(specimen_, F_, length))); }

  /// The same of what is left after long steps in which the body is held, beyond what swelling brings: in one step a
  /// viscous strain may follow that is taken from the stress in the next.
  double held(double length) const {
    constexpr int steps = 3;
    const Material& material = *specimen_.material;
    Point body = point_, swollen{{}, rest_};
    double most = 0, t = sudden_;
    for (int k = 0; k < steps; ++k, t += length) {
      swollen = hold(material, t, length, I_, swollen);
      body = hold(material, t, length, F_, body);
      most = larger(most, times(body.cauchy - swollen.cauchy));
    }
    return most;
  }

 private:
  Tensor above_rest(const Tensor& cauchy) const { return cauchy + specimen_.rest_pressure() * I_; }

  /// The deviators or the pressures: the larger ratio.
  double times(const Tensor& found) const {
    const Tensor sudden = above_rest(point_.cauchy);
    const double shear = stable_norm(deviator(sudden)), pressure = std::abs(sudden.trace());
    const double least = std::max(1e-3 * (shear + pressure), specimen_.least_stress());
    return std::max(stable_norm(deviator(found)) / std::max(shear, least),
                    std::abs(found.trace()) / std::max(pressure, least));
  }

  const Specimen& specimen_;
  double sudden_;
  Tensor I_ = Tensor::Identity(), F_;
  std::vector<double> rest_;
  Point point_;
};

/// Of steps of these lengths: the first that makes too much of the stress, what it makes of it, and the most that any
/// does.
struct Excess {
  double length, times, worst;
};

std::optional<Excess> excess(const Struck& struck, double (Struck::*after)(double) const, double most) {
  std::optional<Excess> found;
  try {
    for (const double length : lengths) {
      const double times = (struck.*after)(length);
      if (!found && !(times <= most)) found = Excess{length, times, times};
      if (found) found->worst = larger(found->worst, times);
    }
  } catch (const MaterialFailure&) {  // of the length of a step
  }
  return found;
}

/// But for what goes with the calls, whatever their lengths.
std::optional<Excess> excess_when_held(const Struck& struck) {
  constexpr double brief = 1e-6;  // [s]
  return struck.held(brief) <= most_held ? excess(struck, &Struck::held, most_held) : std::nullopt;
}

std::string held_words(double length, double times) {
  return "at constant strain the stress becomes " + rounded(times) + " times its first value in steps of " +
         rounded(length) +
         " s. The relaxation is integrated explicitly, or an iteration ends before it converges: it overshoots in "
         "steps longer than the relaxation time";
}

TestResult too_much(double times, double most, const std::string& words) {
  return failed(causes::dissipation, times, most, words + ", and the model does not request a shorter step");
}

}  // namespace

std::optional<TestResult> long_steps(const Specimen& specimen, double sudden) {
  const auto judge = [&]() -> std::optional<TestResult> {
    const Struck struck(specimen, sudden);
    if (const auto found = excess(struck, &Struck::moved, most_moved)) {
      return too_much(found->worst, most_moved,
                      "a step of " + rounded(found->length) + " s gives " + rounded(found->times) +
                          " times the stress of a very short step");
    }
    const auto found = excess_when_held(struck);
    if (!found) return std::nullopt;
    return too_much(found->worst, most_held, held_words(found->length, found->times));
  };
  return if_taken(judge, std::nullopt);  // it may refuse the length of a step
}

std::string overshoot(const Specimen& specimen) {
  constexpr double sudden = 1e-9;  // [s]
  if (!specimen.rate_dependent()) return {};
  const auto words = [&] {
    const auto found = excess_when_held(Struck(specimen, sudden));
    return found ? held_words(found->length, found->times) : std::string();
  };
  return if_taken(words, {});
}

}  // namespace assay::check
