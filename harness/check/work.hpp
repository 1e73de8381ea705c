// SPDX-License-Identifier: BSD-3-Clause
// The work on a body along a history from rest, and what the test of dissipation is made of.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "harness/check/specimen.hpp"

namespace assay::check {

/// [J/m^3], by the trapezoidal rule.
class Work {
 public:
  Work(const Specimen& specimen, double length) : material_(*specimen.material), length_(length) {
    now_.state = specimen.rest_state();
  }

  /// A step of the history to F1, `length` long [s].
  void step(const Tensor& F1) {
    now_ = stepped(material_, t_, length_, F0_, F1, now_.state);
    const Tensor P1 = first_piola_kirchhoff(now_.cauchy, F1);
    const double work = 0.5 * (P0_ + P1).cwiseProduct(F1 - F0_).sum();
    done_ += work;
    paid_ += std::abs(work);
    F0_ = F1, P0_ = P1, t_ += length_;
  }

  double done() const { return done_; }
  double paid() const { return paid_; }                    ///< and returned, both counted as positive
  const Tensor& stress() const { return now_.cauchy; }     ///< now [Pa]
  double largest() const { return size_of(now_.cauchy); }  ///< component of it
  const std::vector<double>& state() const { return now_.state; }

 private:
  const Material& material_;
  double length_, t_ = 0, done_ = 0, paid_ = 0;
  Point now_;
  Tensor F0_ = Tensor::Identity(), P0_ = Tensor::Zero();
};

/// Of work that comes out, over that which was done and returned, however little there was.
inline double share_of_work(const Specimen& specimen, double out, const Work& work) {
  return out / std::max(work.paid(), specimen.least_stress() * specimen.amplitude);
}

/// Whether a law of the total deformation gives work around closed paths in the space of strains. Into a result that
/// has passed: a failure, or a remark where the stress has no potential and is of a kind in common use. times: of the
/// whole path [s]. Laws in increments have the limit of those: none of them stores energy exactly.
void judge_potential(const Specimen& specimen, const std::vector<double>& times, TestResult& result);

/// A material that has yielded is taken once around a cycle of strain within its elastic range: the most work that
/// comes out of it, over that of loading it once more. Nothing for what does not yield, or depends on the rate.
std::optional<double> out_of_a_cycle_after_yield(const Specimen& specimen);

/// Of a model without memory, what motion adds to its stress takes work, whichever way the body moves. Viscosity of one
/// sign in compression and another in extension gives back in a cycle what it took, so that no cycle shows it. times:
/// over which a strain of 1 goes [s]. Nothing where that holds, or the model is another.
std::optional<TestResult> viscosity(const Specimen& specimen, const std::vector<double>& times);

/// What relaxes bears no more in a long step than in a sudden one [s], and no more after a long step in which it is
/// held. Nothing where that holds, or where the material asks for shorter steps.
std::optional<TestResult> long_steps(const Specimen& specimen, double sudden);

/// What a body does in a long step in which it is held, one sentence: the relaxation of an explicit law overshoots in
/// a step that is longer than its time. Empty where it bears no more after it than before.
std::string overshoot(const Specimen& specimen);

}  // namespace assay::check
