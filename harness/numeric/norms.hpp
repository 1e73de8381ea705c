// SPDX-License-Identifier: BSD-3-Clause
// Norms and largest values, the norms of an error over many points, and the order observed between two resolutions. A
// NaN among largest values is the result: std::max and Eigen's maxCoeff would drop it, and what is no number would
// count as no error.
#pragma once

#include <Eigen/Core>
#include <cmath>

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

/// The larger one; NaN if one of them is.
inline double larger(double a, double b) { return a >= b || a != a ? a : b; }

/// The largest |component|; NaN if one of them is.
double largest_of(const auto& A) { return A.cwiseAbs().template maxCoeff<Eigen::PropagateNaN>(); }

/// Volume-weighted L2 and L-infinity of a field's error, point by point.
class NormAccumulator {
 public:
  /// squared: |error|^2 at a point of that volume.
  void add(double volume, double squared) {
    weight_ += volume;
    sum_ += volume * squared;
    if (!(squared <= largest_) && largest_ == largest_) largest_ = squared;  // a NaN enters and stays
  }
  double l2() const { return weight_ > 0 ? std::sqrt(sum_ / weight_) : 0; }
  double linf() const { return std::sqrt(largest_); }

 private:
  double weight_ = 0, sum_ = 0, largest_ = 0;
};

/// Order p of error ~ h^p from two resolutions.
inline double observed_order(double h_coarse, double error_coarse, double h_fine, double error_fine) {
  return std::log(error_coarse / error_fine) / std::log(h_coarse / h_fine);
}

}  // namespace assay
