// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/foreign/membrane.hpp"

#include <cmath>

namespace assay::adapters {

namespace {

double area_of(const Tensor& F) { return F(0, 0) * F(1, 1) - F(0, 1) * F(1, 0); }

/// d ln J2 along dF = E.
double area_rate(const Tensor& F, const Tensor& E) {
  return (E(0, 0) * F(1, 1) + F(0, 0) * E(1, 1) - E(0, 1) * F(1, 0) - F(0, 1) * E(1, 0)) / area_of(F);
}

}  // namespace

double thinning_of(const ForeignModel& model) { return model.thickness / (1 - model.thickness); }

Tensor with_thickness(const ForeignModel& model, const Tensor& F) {
  Tensor own = F;
  own(2, 2) = std::pow(area_of(F), -thinning_of(model));
  return own;
}

Tensor rate_with_thickness(const ForeignModel& model, const Tensor& F, const Tensor& E) {
  Tensor own = E;
  own(2, 2) = -thinning_of(model) * F(2, 2) * area_rate(F, E);
  return own;
}

double membrane_factor(const ForeignModel& model, const Tensor& F) { return with_thickness(model, F)(2, 2) / F(2, 2); }

double membrane_factor_rate(const ForeignModel& model, const Tensor& F, const Tensor& E) {
  return -thinning_of(model) * area_rate(F, E) - E(2, 2) / F(2, 2);
}

}  // namespace assay::adapters
