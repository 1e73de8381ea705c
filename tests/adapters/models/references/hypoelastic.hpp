// SPDX-License-Identifier: BSD-3-Clause
// The rate equations of the hypoelastic models.
#pragma once

#include "tests/adapters/models/reference_integration.hpp"

namespace assay::model_tests {

using Spin = std::function<Tensor(const Tensor& F, const Tensor& l)>;

/// dsigma/dt = Omega sigma - sigma Omega + lambda tr(d) I + 2 mu d, from rest.
inline Tensor hypoelastic_stress(const History& history, const Lame& hooke, const Spin& spin) {
  Values y(9, 0.0);
  const Equations equations = [&](const Values& now, Values& rate, double t) {
    const Tensor F = history.F(t), l = velocity_gradient(history, t), sigma = tensor_of(now.data());
    const Tensor omega = spin(F, l);
    nine(omega * sigma - sigma * omega + hooke(symmetric_part(l)), rate.data());
  };
  integrate_in_pieces(equations, y, 0, history.end, 60);
  return tensor_of(y.data());
}

inline Tensor jaumann_spin(const Tensor&, const Tensor& l) { return l - symmetric_part(l); }

/// Rdot R^T = (Fdot - R Udot) U^-1 R^T with U Udot + Udot U = Cdot solved in the axes of U.
inline Tensor green_naghdi_spin(const Tensor& F, const Tensor& l) {
  const Tensor F_rate = l * F, C_rate = F_rate.transpose() * F + F.transpose() * F_rate;
  const Eigen::SelfAdjointEigenSolver<Tensor> eigen(F.transpose() * F);
  const Eigen::Vector3d stretch = eigen.eigenvalues().cwiseSqrt();
  const Tensor& V = eigen.eigenvectors();
  Tensor U_rate = V.transpose() * C_rate * V;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) U_rate(i, j) /= stretch(i) + stretch(j);
  }
  U_rate = V * U_rate * V.transpose();
  const Tensor U_inverse = V * stretch.cwiseInverse().asDiagonal() * V.transpose(), R = F * U_inverse;
  return (F_rate - R * U_rate) * U_inverse * R.transpose();
}

/// Xiao, Bruhns and Meyers (1997): w + sum over i != j of ((1 + z)/(1 - z) + 2 / ln z) P_i d P_j, z = b_i / b_j.
inline Tensor logarithmic_spin(const Tensor& F, const Tensor& l) {
  const Eigen::SelfAdjointEigenSolver<Tensor> eigen(F * F.transpose());
  const Tensor d = symmetric_part(l), in_axes = eigen.eigenvectors().transpose() * d * eigen.eigenvectors();
  Tensor N = Tensor::Zero();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const double x = std::log(eigen.eigenvalues()(i) / eigen.eigenvalues()(j));
      const double factor =
          std::abs(x) < 1e-2 ? x * (-1.0 / 6 + x * x * (1.0 / 360 - x * x / 15120)) : 2 / x - 1 / std::tanh(x / 2);
      N(i, j) = factor * in_axes(i, j);
    }
  }
  return l - d + eigen.eigenvectors() * N * eigen.eigenvectors().transpose();
}

}  // namespace assay::model_tests
