// SPDX-License-Identifier: BSD-3-Clause
// tau(xi) of one time by a formula, without a slope.
#pragma once

#include <functional>
#include <vector>

#include "harness/exact/response.hpp"

namespace assay {

class MadeUpCurve final : public ResponseAtTime {
 public:
  explicit MadeUpCurve(std::function<Tensor(double xi)> tau, std::vector<double> fronts = {})
      : tau_(std::move(tau)), fronts_(std::move(fronts)) {}
  void at(double xi, Tensor& tau, Tensor& dtau_dxi) const override { tau = tau_(xi), dtau_dxi.setZero(); }
  std::vector<double> fronts() const override { return fronts_; }

 private:
  std::function<Tensor(double xi)> tau_;
  std::vector<double> fronts_;
};

}  // namespace assay
