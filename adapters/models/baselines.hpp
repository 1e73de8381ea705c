// SPDX-License-Identifier: BSD-3-Clause
// What models share on the baselines: hypoelasticity, where tau = J sigma F^-T, and elasticity that is linear in the
// Green strain E = (F^T F - I) / 2.
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

template <class S>
TensorOf<S> green_strain(const TensorOf<S>& F) {
  TensorOf<S> E = right_cauchy_green(F);
  for (int i = 0; i < 3; ++i) E(i, i) -= S(1);
  return S(0.5) * E;
}

/// sigma = F S F^T / J [Pa].
template <class S>
TensorOf<S> cauchy_of(const TensorOf<S>& F, const TensorOf<S>& second_piola_kirchhoff) {
  return (S(1) / determinant(F)) * push_forward(F, second_piola_kirchhoff);
}

/// Exact first Piola-Kirchhoff stress P = F S of the baselines and its slope [Pa], where S11 = c11 E11, S22 = c12 E11,
/// S33 = c13 E11 and S12 = 2 shear E12. With gamma = 2 eps in simple shear: E11 = gamma^2 / 2, E12 = gamma / 2.
inline bool green_strain_baseline(double c11, double c12, double c13, double shear, int baseline, double eps,
                                  Tensor& tau, Tensor& slope) {
  if (baseline == ASSAY_BASELINE_SIMPLE_SHEAR) {
    const double gamma = 2 * eps, square = gamma * gamma;
    tau(0, 0) = 0.5 * c11 * square;
    tau(0, 1) = shear * gamma;
    tau(1, 0) = (shear + 0.5 * c11 * square) * gamma;
    tau(1, 1) = (0.5 * c12 + shear) * square;
    tau(2, 2) = 0.5 * c13 * square;
    slope(0, 0) = 2 * c11 * gamma;
    slope(0, 1) = 2 * shear;
    slope(1, 0) = 2 * shear + 3 * c11 * square;
    slope(1, 1) = 2 * (c12 + 2 * shear) * gamma;
    slope(2, 2) = 2 * c13 * gamma;
    return true;
  }
  if (baseline != ASSAY_BASELINE_UNIAXIAL_STRAIN) return false;
  const double s = 1 + eps, E11 = eps * (1 + 0.5 * eps);
  tau(0, 0) = c11 * s * E11;
  tau(1, 1) = c12 * E11;
  tau(2, 2) = c13 * E11;
  slope(0, 0) = c11 * (E11 + s * s);
  slope(1, 1) = c12 * s;
  slope(2, 2) = c13 * s;
  return true;
}

}  // namespace assay::models
