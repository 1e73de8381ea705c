// SPDX-License-Identifier: BSD-3-Clause
// The work on a body along a history from rest.
#pragma once

#include <cmath>
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
  double paid() const { return paid_; }                                 ///< and returned, both counted as positive
  const Tensor& stress() const { return now_.cauchy; }                  ///< now [Pa]
  double largest() const { return now_.cauchy.cwiseAbs().maxCoeff(); }  ///< component of it
  const std::vector<double>& state() const { return now_.state; }

 private:
  const Material& material_;
  double length_, t_ = 0, done_ = 0, paid_ = 0;
  Point now_;
  Tensor F0_ = Tensor::Identity(), P0_ = Tensor::Zero();
};

}  // namespace assay::check
