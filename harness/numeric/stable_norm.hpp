// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace assay {

/// Frobenius norm whose squares neither overflow nor vanish. Eigen 3.4's own stops at an assertion of its own where a
/// matrix of fixed size is no vector.
template <class Derived>
double stable_norm(const Eigen::MatrixBase<Derived>& A) {
  return A.derived().eval().reshaped().stableNorm();
}

/// The vector of length 1 along v, which is not zero, however long or short v is. Eigen's stableNormalized() overflows
/// in the length of a vector whose components do not.
inline Eigen::Vector3d unit_along(const Eigen::Vector3d& v) { return (v / v.cwiseAbs().maxCoeff()).normalized(); }

}  // namespace assay
