// SPDX-License-Identifier: BSD-3-Clause
// Largest errors. A NaN among them is the result: std::max and Eigen's maxCoeff would drop it, and what is no number
// would count as no error.
#pragma once

#include <Eigen/Core>

namespace assay {

/// The larger one; NaN if one of them is.
inline double larger(double a, double b) { return a >= b || a != a ? a : b; }

/// The largest |component|; NaN if one of them is.
double largest_of(const auto& A) { return A.cwiseAbs().template maxCoeff<Eigen::PropagateNaN>(); }

}  // namespace assay
