// SPDX-License-Identifier: BSD-3-Clause
// 3 x 3 tensors of any scalar type, for the models of this folder.
#pragma once

#include <Eigen/Core>
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

}  // namespace assay::models
