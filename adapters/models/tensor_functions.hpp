// SPDX-License-Identifier: BSD-3-Clause
// Isotropic functions of 3 x 3 tensors for the models of this folder. Rational operations only, no eigenvectors:
// nothing happens at repeated eigenvalues, and a differentiating scalar type gives exact derivatives.
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <array>
#include <cmath>
#include <unsupported/Eigen/AutoDiff>

namespace assay::models {

template <class S>
using TensorOf = Eigen::Matrix<S, 3, 3>;
using Tensor = TensorOf<double>;

inline double value_of(double x) { return x; }
template <class D>
double value_of(const Eigen::AutoDiffScalar<D>& x) {
  return x.value();
}

/// The values alone.
template <class S>
Tensor values_of(const TensorOf<S>& A) {
  Tensor values;
  for (int i = 0; i < 9; ++i) values.data()[i] = value_of(A.data()[i]);
  return values;
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

/// Largest component in magnitude, of the values alone.
template <class S>
double magnitude(const TensorOf<S>& A) {
  double largest = 0;
  for (int i = 0; i < 9; ++i) largest = std::fmax(largest, std::abs(value_of(A.data()[i])));
  return largest;
}

template <class S>
S determinant(const TensorOf<S>& A) {
  return A(0, 0) * (A(1, 1) * A(2, 2) - A(1, 2) * A(2, 1)) - A(0, 1) * (A(1, 0) * A(2, 2) - A(1, 2) * A(2, 0)) +
         A(0, 2) * (A(1, 0) * A(2, 1) - A(1, 1) * A(2, 0));
}

template <class S>
TensorOf<S> inverse(const TensorOf<S>& A) {
  const S scale = S(1) / determinant(A);
  TensorOf<S> B;
  for (int i = 0; i < 3; ++i) {
    const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    for (int j = 0; j < 3; ++j) {
      const int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      B(j, i) = (A(i1, j1) * A(i2, j2) - A(i1, j2) * A(i2, j1)) * scale;
    }
  }
  return B;
}

template <class S>
S trace(const TensorOf<S>& A) {
  return A(0, 0) + A(1, 1) + A(2, 2);
}

template <class S>
TensorOf<S> deviator(const TensorOf<S>& A) {
  TensorOf<S> D = A;
  const S mean = trace(A) / S(3);
  for (int i = 0; i < 3; ++i) D(i, i) -= mean;
  return D;
}

/// A : B.
template <class S>
S contraction(const TensorOf<S>& A, const TensorOf<S>& B) {
  S sum(0);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) sum += A(i, j) * B(i, j);
  }
  return sum;
}

template <class S>
TensorOf<S> symmetric(const TensorOf<S>& A) {
  return S(0.5) * (A + A.transpose());
}

/// Rotation R of the polar decomposition A = R U: Newton's iteration R <- (R + R^-T) / 2 (Higham).
template <class S>
TensorOf<S> rotation_of(const TensorOf<S>& A) {
  constexpr int most = 40;
  TensorOf<S> R = A;
  for (int k = 0; k < most; ++k) {
    const TensorOf<S> next = S(0.5) * (R + inverse(R).transpose());
    const TensorOf<S> change = next - R;
    R = next;
    if (magnitude(change) < 1e-9) break;  // quadratic: the next change is below 1e-16; derivatives lag by one
  }
  return S(0.5) * (R + inverse(R).transpose());
}

/// Square root of a symmetric positive definite tensor (Denman and Beavers).
template <class S>
TensorOf<S> square_root(const TensorOf<S>& A) {
  constexpr int most = 40;
  TensorOf<S> Y = A, Z = TensorOf<S>::Identity();
  for (int k = 0, last = most; k < last; ++k) {
    const TensorOf<S> Y_inverse = inverse(Y), Z_inverse = inverse(Z);
    const TensorOf<S> change = S(0.5) * (Z_inverse - Y);
    Y += change;
    Z = S(0.5) * (Z + Y_inverse);
    if (last == most && magnitude(change) < 1e-9 * magnitude(Y)) last = k + 2;
  }
  return symmetric(Y);
}

/// sum over k < terms of coefficient(k) W^k, W symmetric: Horner's rule on three scalars, since every power of W is
/// a combination of I, W and W^2 (Cayley and Hamilton: W^3 = I1 W^2 - I2 W + I3 I).
template <class S, class Coefficient>
TensorOf<S> power_series(const TensorOf<S>& W, int terms, const Coefficient& coefficient) {
  const TensorOf<S> square = W * W;
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

/// Frobenius norm of the values alone.
template <class S>
double size_of(const TensorOf<S>& A) {
  double sum = 0;
  for (int i = 0; i < 9; ++i) sum += value_of(A.data()[i]) * value_of(A.data()[i]);
  return std::sqrt(sum);
}

/// Logarithm of a symmetric positive definite tensor: ln A = 2 artanh Z, Z = (A - I) (A + I)^-1; square roots first
/// where A is far from I.
template <class S>
TensorOf<S> logarithm(TensorOf<S> A) {
  constexpr double near = 0.55, least = 1e-5;
  constexpr int most_roots = 60;
  const TensorOf<S> I = TensorOf<S>::Identity();
  TensorOf<S> Z = (A - I) * inverse(TensorOf<S>(A + I));
  double factor = 2;
  for (int k = 0; k < most_roots && size_of(Z) > near; ++k) {
    A = square_root(A);
    Z = (A - I) * inverse(TensorOf<S>(A + I));
    factor *= 2;
  }
  // |Z|^(2 terms) < 1e-18, and one term more for the derivatives.
  const int terms = 2 + static_cast<int>(-41.5 / (2 * std::log(std::fmin(near, std::fmax(least, size_of(Z))))));
  const TensorOf<S> W = symmetric(TensorOf<S>(Z * Z));
  const TensorOf<S> sum = power_series(W, terms, [](int k) { return 1.0 / (2 * k + 1); });
  return symmetric(TensorOf<S>(S(factor) * (Z * sum)));
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
  double size = size_of(A);
  for (; size > near; size *= 0.5) ++squarings;
  A *= S(std::ldexp(1.0, -squarings));
  int terms = 2;
  for (double left_out = size; left_out > 1e-18 && terms < most_terms; ++terms) left_out *= size / terms;
  TensorOf<S> sum = power_series(A, terms, [](int k) { return inverse_factorials[static_cast<std::size_t>(k)]; });
  for (int k = 0; k < squarings; ++k) sum = TensorOf<S>(sum * sum);
  return symmetric(sum);
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

/// Symmetric tensor from the state: 11, 22, 33, 12, 13, 23.
inline Tensor symmetric_from(const double* six) {
  Tensor A;
  A << six[0], six[3], six[4], six[3], six[1], six[5], six[4], six[5], six[2];
  return A;
}

template <class S>
void put_symmetric(const TensorOf<S>& A, S* six) {
  six[0] = A(0, 0), six[1] = A(1, 1), six[2] = A(2, 2);
  six[3] = S(0.5) * (A(0, 1) + A(1, 0)), six[4] = S(0.5) * (A(0, 2) + A(2, 0)), six[5] = S(0.5) * (A(1, 2) + A(2, 1));
}

}  // namespace assay::models
