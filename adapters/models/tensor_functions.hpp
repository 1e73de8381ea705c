// SPDX-License-Identifier: BSD-3-Clause
// 3 x 3 tensors of any scalar type, and their isotropic functions, for the models of this folder. Rational operations
// only, no eigenvectors: nothing happens at repeated eigenvalues, and a differentiating scalar type gives exact
// derivatives.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <type_traits>
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

/// A : A of the values alone.
template <class S>
double square_of_size(const TensorOf<S>& A) {
  double sums[3] = {};
  for (int i = 0; i < 9; ++i) sums[i / 3] += value_of(A.data()[i]) * value_of(A.data()[i]);
  return sums[0] + sums[1] + sums[2];
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

/// |A| = sqrt(A : A); its slope is not defined at zero and given as zero.
template <class S>
S norm(const TensorOf<S>& A) {
  using std::sqrt;
  const S square = contraction(A, A);
  return value_of(square) > 0 ? S(sqrt(square)) : S(0);
}

template <class S>
TensorOf<S> symmetric(const TensorOf<S>& A) {
  return S(0.5) * (A + A.transpose());
}

/// A^T B where it is known to be symmetric, and then is to the last bit.
template <class S>
TensorOf<S> symmetric_product(const TensorOf<S>& A, const TensorOf<S>& B) {
  TensorOf<S> C;
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j) C(i, j) = C(j, i) = A(0, i) * B(0, j) + A(1, i) * B(1, j) + A(2, i) * B(2, j);
  }
  return C;
}

/// F F^T.
template <class S>
TensorOf<S> left_cauchy_green(const TensorOf<S>& F) {
  const TensorOf<S> transposed = F.transpose();
  return symmetric_product(transposed, transposed);
}

/// F^T F.
template <class S>
TensorOf<S> right_cauchy_green(const TensorOf<S>& F) {
  return symmetric_product(F, F);
}

/// F A F^T of a symmetric tensor A.
template <class S>
TensorOf<S> push_forward(const TensorOf<S>& F, const TensorOf<S>& A) {
  const TensorOf<S> transposed = F.transpose();
  return symmetric_product(TensorOf<S>(A * transposed), transposed);
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

/// A tensor and its rate.
struct Moving {
  Tensor value, rate;
};

/// f(A) and its rate along dA/dt = A_rate, f a function of a tensor of any scalar type.
Moving moving_along(const auto& f, const Tensor& A, const Tensor& A_rate) {
  using Along = Eigen::AutoDiffScalar<Eigen::Matrix<double, 1, 1>>;
  TensorOf<Along> moving;
  for (int i = 0; i < 9; ++i) moving.data()[i] = Along(A.data()[i], Eigen::Matrix<double, 1, 1>(A_rate.data()[i]));
  const TensorOf<Along> result = f(moving);
  Moving found;
  for (int i = 0; i < 9; ++i) {
    found.value.data()[i] = result.data()[i].value();
    found.rate.data()[i] = result.data()[i].derivatives()(0);
  }
  return found;
}

Tensor derivative_along(const auto& f, const Tensor& A, const Tensor& A_rate) {
  return moving_along(f, A, A_rate).rate;
}

/// ln(A) / 2.
inline constexpr auto half_logarithm = [](const auto& A) { return std::decay_t<decltype(A)>(logarithm(A) * 0.5); };

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
