// SPDX-License-Identifier: BSD-3-Clause
// Isotropic functions of 3 x 3 tensors for the models of this folder. Rational operations only, no eigenvectors:
// nothing happens at repeated eigenvalues, and a differentiating scalar type gives exact derivatives.
#pragma once

#include <array>
#include <cmath>
#include <type_traits>

#include "adapters/models/tensor_algebra.hpp"

namespace assay::models {

/// Rotation R of the polar decomposition A = R U: Newton's iteration R <- (R + R^-T) / 2 (Higham).
template <class S>
TensorOf<S> rotation_of(const TensorOf<S>& A) {
  constexpr int most = 40;
  const auto next = [](const TensorOf<S>& R) { return TensorOf<S>(S(0.5) * (R + inverse(R).transpose())); };
  TensorOf<S> R = A;
  for (int k = 0; k < most; ++k) {
    const TensorOf<S> before = R;
    R = next(R);
    if (square_of_size(TensorOf<S>(R - before)) < 1e-17) break;  // quadratic: the next change is below 1e-16
  }
  if constexpr (!std::is_same_v<S, double>) R = next(R);  // derivatives lag by one
  return R;
}

/// Upper triangular G with G^T G = A, A symmetric positive definite: a cheap deformation gradient with right
/// Cauchy-Green tensor A, where any rotation will do.
template <class S>
TensorOf<S> upper_root(const TensorOf<S>& A) {
  using std::sqrt;
  TensorOf<S> G = TensorOf<S>::Zero();
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j) {
      S rest = A(i, j);
      for (int k = 0; k < i; ++k) rest -= G(k, i) * G(k, j);
      G(i, j) = i == j ? S(sqrt(rest)) : S(rest / G(i, i));
    }
  }
  return G;
}

/// Square root of a symmetric positive definite tensor: U of its upper root G = R U (Higham).
template <class S>
TensorOf<S> square_root(const TensorOf<S>& A) {
  const TensorOf<S> G = upper_root(A);
  return symmetric(TensorOf<S>(rotation_of(G).transpose() * G));
}

/// sum over k < terms of coefficient(k) W^k, W symmetric: Horner's rule on three scalars, since every power of W is
/// a combination of I, W and W^2 (Cayley and Hamilton: W^3 = I1 W^2 - I2 W + I3 I).
template <class S, class Coefficient>
TensorOf<S> power_series(const TensorOf<S>& W, int terms, const Coefficient& coefficient) {
  const TensorOf<S> square = symmetric_product(W, W);
  const S I1 = trace(W), I2 = S(0.5) * (I1 * I1 - trace(square)), I3 = determinant(W);
  S a(coefficient(terms - 1)), b(0), c(0);  // of I, W, W^2
  for (int k = terms - 2; k >= 0; --k) {
    const S next_b = a - I2 * c, next_c = b + I1 * c;
    a = I3 * c + S(coefficient(k));
    b = next_b;
    c = next_c;
  }
  TensorOf<S> sum = b * W + c * square;
  for (int i = 0; i < 3; ++i) sum(i, i) += a;
  return sum;
}

/// Logarithm of a symmetric positive definite tensor: ln A = 2 artanh Z, Z = (A - I) (A + I)^-1 = I - 2 (A + I)^-1;
/// square roots first where A is far from I.
template <class S>
TensorOf<S> logarithm(TensorOf<S> A) {
  constexpr double near = 0.55;
  constexpr int most_roots = 60, most_terms = 40;
  const TensorOf<S> I = TensorOf<S>::Identity();
  const auto ratio_of = [&](const TensorOf<S>& B) { return TensorOf<S>(I - S(2) * inverse(TensorOf<S>(B + I))); };
  TensorOf<S> Z = ratio_of(A);
  double factor = 2;
  for (int k = 0; k < most_roots && square_of_size(Z) > near * near; ++k) {
    A = square_root(A);
    Z = ratio_of(A);
    factor *= 2;
  }
  const double ratio = square_of_size(Z);
  int terms = 2;  // |Z|^(2 (terms - 1)) < 1e-18: one term more for the derivatives
  for (double left_out = ratio; left_out > 1e-18 && terms < most_terms; ++terms) left_out *= ratio;
  const TensorOf<S> W = symmetric_product(Z, Z);
  const TensorOf<S> sum = power_series(W, terms, [](int k) { return 1.0 / (2 * k + 1); });
  return S(factor) * symmetric_product(Z, sum);
}

/// Exponential of a symmetric tensor: its power series after scaling, then squaring.
template <class S>
TensorOf<S> exponential(TensorOf<S> A) {
  constexpr double near = 1;
  constexpr int most_terms = 21;
  static constexpr auto inverse_factorials = [] {
    std::array<double, most_terms> f{1};
    for (int k = 1; k < most_terms; ++k) f[static_cast<std::size_t>(k)] = f[static_cast<std::size_t>(k - 1)] / k;
    return f;
  }();
  int squarings = 0;
  double size = std::sqrt(square_of_size(A));
  for (; size > near && std::isfinite(size); size *= 0.5) ++squarings;
  A *= S(std::ldexp(1.0, -squarings));
  int terms = 2;
  for (double left_out = size; left_out > 1e-18 && terms < most_terms; ++terms) left_out *= size / terms;
  TensorOf<S> sum = power_series(A, terms, [](int k) { return inverse_factorials[static_cast<std::size_t>(k)]; });
  for (int k = 0; k < squarings; ++k) sum = symmetric_product(sum, sum);
  return sum;
}

/// d f(A) / dt along dA/dt = A_rate, f a function of a tensor of any scalar type.
template <class Function>
Tensor derivative_along(const Function& f, const Tensor& A, const Tensor& A_rate) {
  using Along = Eigen::AutoDiffScalar<Eigen::Matrix<double, 1, 1>>;
  TensorOf<Along> moving;
  for (int i = 0; i < 9; ++i) moving.data()[i] = Along(A.data()[i], Eigen::Matrix<double, 1, 1>(A_rate.data()[i]));
  const TensorOf<Along> result = f(moving);
  Tensor rate;
  for (int i = 0; i < 9; ++i) rate.data()[i] = result.data()[i].derivatives()(0);
  return rate;
}

/// e = ln(F A F^T) / 2.
template <class S>
TensorOf<S> logarithmic_strain(const TensorOf<S>& F, const TensorOf<S>& A) {
  return S(0.5) * logarithm(push_forward(F, A));
}

/// F = R U, its rates along Fdot = l F, and the spin Rdot R^T.
struct PolarRates {
  Tensor R, U, U_rate, spin;
};

inline PolarRates polar_rates(const Tensor& F, const Tensor& l) {
  PolarRates p;
  p.R = rotation_of(F);
  p.U = symmetric(Tensor(p.R.transpose() * F));
  // R^T Fdot = W U + Udot with W = R^T Rdot. Its skew part (W U + U W)/2 has the axial vector (tr U I - U) w / 2.
  const Tensor M = p.R.transpose() * l * F, skew = M - M.transpose();
  const Eigen::Vector3d axial(skew(2, 1), skew(0, 2), skew(1, 0));
  const Eigen::Vector3d w = inverse(Tensor(trace(p.U) * Tensor::Identity() - p.U)) * axial;
  Tensor W;
  W << 0, -w(2), w(1), w(2), 0, -w(0), -w(1), w(0), 0;
  p.U_rate = symmetric(Tensor(M - W * p.U));
  p.spin = p.R * W * p.R.transpose();
  return p;
}

}  // namespace assay::models
