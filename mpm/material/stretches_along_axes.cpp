// SPDX-License-Identifier: BSD-3-Clause
// The stretches by which cpGIMP sizes its domains in space.

#if ASSAY_DIMENSION == 3
#include <Eigen/Eigenvalues>

#include "mpm/basis/basis_cpgimp.hpp"

namespace assay::mpm {

Vec<3> stretches_along_axes(const Mat<3>& F) {
  using Matrix = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  const Eigen::Map<const Matrix> gradient(F.data());
  const Matrix U = Eigen::SelfAdjointEigenSolver<Matrix>(gradient.transpose() * gradient).operatorSqrt();
  return {U(0, 0), U(1, 1), U(2, 2)};
}

}  // namespace assay::mpm
#endif
