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

}  // namespace assay
