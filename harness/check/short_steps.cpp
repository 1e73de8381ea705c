// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/short_steps.hpp"

#include <algorithm>
#include <cmath>

#include "harness/check/judge.hpp"
#include "harness/check/precision.hpp"
#include "harness/check/samples.hpp"
#include "harness/stable_norm.hpp"

namespace assay::check {

namespace {

constexpr double usual = 1e-4, less_than_usual = 3e-5;  ///< strains of steps that every model takes
constexpr double tried[] = {1e-5, 1e-6, 1e-7, 1e-8};

/// A stretch of size one: a turn of the body would turn its stress, which hosts do in place of some models.
Tensor direction(const Space& space) {
  constexpr double small = 1e-3;
  const Tensor stretch = space.stretch(small, 0.3) - Tensor::Identity();
  const Tensor d = stretch + stretch.transpose();
  return d / stable_norm(d);
}

/// The stress that steps of a strain from the beginning of a sample make, over that strain.
class Answer {
 public:
  Answer(const Specimen& specimen, const Sample& sample)
      : material_(*specimen.material), s_(sample), d_(direction(specimen.space)), still_(after(0)) {}

  double to(double strain) const { return stable_norm(Tensor(after(strain) - still_)) / strain; }
  double stress() const { return stable_norm(still_); }

 private:
  Tensor after(double strain) const {
    return stepped(material_, s_.t, s_.dt, s_.F0, (Tensor::Identity() + strain * d_) * s_.F0, s_.state0).cauchy;
  }

  const Material& material_;
  const Sample& s_;
  Tensor d_, still_;
};

}  // namespace

std::optional<TestResult> short_steps(const Specimen& specimen) {
  constexpr double share = 0.01, least_stiffness = 0.05, alike = 0.3;
  const double digits = is_of_single_precision(specimen) ? 1e-5 : 1e-10;
  for (const Sample& sample : samples_of(specimen)) {
    try {
      const Answer answer(specimen, sample);
      const double expected = answer.to(usual);
      const bool is_straight = std::abs(answer.to(less_than_usual) - expected) <= alike * expected;
      if (!(expected >= least_stiffness * specimen.modulus) || !is_straight) continue;
      for (const double strain : tried) {
        if (expected * strain < digits / share * answer.stress()) break;
        const double found = answer.to(strain);
        if (!(found < share * expected)) continue;
        TestResult result{.id = "step_halving", .verdict = Verdict::fail, .measure = 1, .threshold = share};
        result.cause = causes::no_convergence;
        result.sentence = "a strain of " + rounded(strain) +
                          " in one step makes no stress in a loaded body, where one of " + rounded(usual) +
                          " does: short steps are left out, and a slow loading makes none at all";
        return result;
      }
    } catch (const MaterialFailure&) {  // of a step at once
    }
  }
  return std::nullopt;
}

}  // namespace assay::check
