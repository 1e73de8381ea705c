// SPDX-License-Identifier: BSD-3-Clause
// Error norms and the order observed between two resolutions.
#pragma once

#include <cmath>

namespace assay {

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
