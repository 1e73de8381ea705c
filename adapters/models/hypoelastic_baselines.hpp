// SPDX-License-Identifier: BSD-3-Clause
// Closed forms of the baselines that the hypoelastic models share: tau = J sigma F^-T.
#pragma once

#include "adapters/models/elastic_constants.hpp"

namespace assay::models {

/// In-plane Cauchy stress of simple shear at constant volume, sigma22 = -sigma11, or its derivative [Pa].
struct PlaneStress {
  double s11, s12;
};

/// Simple shear F = I + 2 eps E2 E1: tau = sigma (I - gamma E1 E2), gamma = 2 eps, and d tau / d eps from d sigma / d
/// eps.
inline void shear_tau(PlaneStress sigma, PlaneStress slope, double eps, Tensor& tau, Tensor& dtau_deps) {
  const double gamma = 2 * eps;
  tau << sigma.s11, sigma.s12 - gamma * sigma.s11, 0, sigma.s12, -sigma.s11 - gamma * sigma.s12, 0, 0, 0, 0;
  dtau_deps << slope.s11, slope.s12 - gamma * slope.s11 - 2 * sigma.s11, 0, slope.s12,
      -slope.s11 - gamma * slope.s12 - 2 * sigma.s12, 0, 0, 0, 0;
}

/// Uniaxial strain F = I + eps E1 E1 does not rotate: whatever the objective rate, sigma = lambda tr(e) I + 2 mu e with
/// e = ln(1 + eps) E1 E1. False for another baseline.
inline bool uniaxial_tau(const ElasticConstants& elastic, int baseline, double eps, Tensor& tau, Tensor& dtau_deps) {
  if (baseline != ASSAY_BASELINE_UNIAXIAL_STRAIN || !(eps > -1)) return false;
  const double stretch = 1 + eps, strain = std::log(stretch), axial = elastic.lambda + 2 * elastic.mu;
  const double side = elastic.lambda * stretch * strain, side_slope = elastic.lambda * (1 + strain);
  tau = Eigen::Vector3d(axial * strain, side, side).asDiagonal();
  dtau_deps = Eigen::Vector3d(axial / stretch, side_slope, side_slope).asDiagonal();
  return true;
}

}  // namespace assay::models
