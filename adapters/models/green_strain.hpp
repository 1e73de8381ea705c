// SPDX-License-Identifier: BSD-3-Clause
// Elasticity that is linear in the Green strain E = (F^T F - I) / 2: what its models share.
#pragma once

#include "adapters/models/tensor_functions.hpp"
#include "harness/assay_material.h"

namespace assay::models {

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
