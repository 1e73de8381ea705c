// SPDX-License-Identifier: BSD-3-Clause
// How much of one tensor another has.
#pragma once

#include <Eigen/Core>

namespace assay::check {

/// The multiple of `along` that is nearest to A, A : along / along : along, of numbers whose squares may overflow or
/// vanish. Not a number along nothing.
template <class M, class N>
double share_along(const Eigen::MatrixBase<M>& A, const Eigen::MatrixBase<N>& along) {
  const double unit = along.cwiseAbs().maxCoeff();
  const auto scaled = (along / unit).eval();
  return (A / unit).cwiseProduct(scaled).sum() / scaled.squaredNorm();
}

}  // namespace assay::check
