// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/short_steps.hpp"

#include <algorithm>
#include <cmath>

#include "harness/check/judge.hpp"
#include "harness/check/precision.hpp"
#include "harness/check/samples.hpp"
#include "harness/numeric/stable_norm.hpp"

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
class AnswerToStep {
 public:
  AnswerToStep(const Specimen& specimen, const Sample& sample)
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

TestResult failed(double measure, double most, std::string sentence, const char* cause) {
  TestResult result{.id = "step_halving", .verdict = Verdict::fail, .measure = measure, .threshold = most};
  result.cause = cause;
  result.sentence = std::move(sentence);
  return result;
}

/// Simple shear whose numbers are powers of two: F F^-1 is the unit tensor to the last bit, and a step in which the
/// body is held has a strain of zero for whoever looks.
Tensor plain_shear(double gamma) {
  Tensor F = Tensor::Identity();
  F(0, 1) = gamma;
  return F;
}

/// The relaxation of a body that is held goes on as that of one that hardly moves.
std::optional<TestResult> rests_when_held(const Specimen& specimen) {
  constexpr double hardly = 1e-9, most = 1e-3;
  constexpr int steps = 8;
  const double gamma = std::exp2(std::floor(std::log2(0.5 * specimen.amplitude)));
  Point loaded;
  loaded.state = specimen.rest_state();
  for (int k = 0; k < steps; ++k) {
    loaded = stepped(*specimen.material, 1.0 * k / steps, 1.0 / steps, plain_shear(gamma * k / steps),
                     plain_shear(gamma * (k + 1) / steps), loaded.state);
  }
  for (const double length : {1e-2, 1.0, 1e2, 1e4}) {  // [s]
    try {
      const auto after = [&](double strain) {
        return stepped(*specimen.material, 1, length, plain_shear(gamma), plain_shear(gamma + strain), loaded.state)
            .cauchy;
      };
      const Tensor held = after(0), moved = after(hardly);
      const double size = std::max(stable_norm(loaded.cauchy), specimen.least_stress());
      const double apart = stable_norm(Tensor(held - moved)) / size;
      if (apart <= most) continue;
      return failed(apart, most,
                    "a body that does not move for " + rounded(length) +
                        " s has another stress than a body that is strained by " + rounded(hardly) +
                        " in this time, by " + percent(apart) +
                        " of the stress: the model skips steps without deformation",
                    causes::drifts);
    } catch (const MaterialFailure&) {  // of the length of a step
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<TestResult> short_steps(const Specimen& specimen) {
  try {
    if (specimen.rate_dependent()) {
      if (auto found = rests_when_held(specimen)) return found;
    }
  } catch (const MaterialFailure&) {  // of the loading
  }
  constexpr double share = 0.01, least_stiffness = 0.05, alike = 0.3;
  const double digits = is_of_single_precision(specimen) ? 1e-5 : 1e-10;
  for (const Sample& sample : samples_of(specimen)) {
    try {
      const AnswerToStep answer(specimen, sample);
      const double expected = answer.to(usual);
      const bool is_straight = std::abs(answer.to(less_than_usual) - expected) <= alike * expected;
      if (!(expected >= least_stiffness * specimen.modulus) || !is_straight) continue;
      for (const double strain : tried) {
        if (expected * strain < digits / share * answer.stress()) break;
        const double found = answer.to(strain);
        if (!(found < share * expected)) continue;
        return failed(found / expected, share,
                      "a strain of " + rounded(strain) +
                          " in one step adds no stress to a loaded body, although a strain of " + rounded(usual) +
                          " does: the model skips small steps, so a slow loading adds no stress at all",
                      causes::no_convergence);
      }
    } catch (const MaterialFailure&) {  // of a step at once
    }
  }
  return std::nullopt;
}

}  // namespace assay::check
