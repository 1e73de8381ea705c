// SPDX-License-Identifier: BSD-3-Clause
// Extrapolation of results of 1, 2, 3 ... sub-steps to a step of length zero (Hairer, Norsett and Wanner, Solving
// Ordinary Differential Equations I, II.9).
#pragma once

#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace assay {

/// Which powers of the length h of a sub-step an increment errs by is not known of a foreign one. Three series are
/// kept, and the one with the least error counts: h, h^2, h^3 ...; of a second order increment h^2, h^3, h^4 ...; of
/// one that is symmetric in time h^2, h^4, h^6 ... The last two only where the results of 1, 2, 3 sub-steps approach
/// each other like 1, 1/4, 1/9.
class Extrapolation {
 public:
  static constexpr int most_columns = 6;

  void clear() { rows_ = 0; }

  /// The result of the next number of sub-steps: 1, 2, 3 ... `scales`: what errors are measured against.
  void add(std::span<const double> result, std::span<const double> scales);

  int columns() const { return rows_; }
  /// Estimated, relative; infinite with one column. Of h^2, h^4 ... it is right even where an odd power is what is
  /// left.
  double error() const { return error_; }
  /// What rounding of the results leaves, relative, whatever the number of columns.
  double rounding() const { return rounding_; }
  const std::vector<double>& best() const { return best_; }
  /// By how much the last result differs from the one before; there must be two.
  double last_change(std::size_t component) const {
    const auto last = static_cast<std::size_t>(rows_) - 1;
    return std::abs(results_[last][component] - results_[last - 1][component]);
  }

 private:
  int rows_ = 0;
  std::array<std::vector<double>, most_columns> results_;
  std::vector<double> value_, change_;
  double first_change_ = 0, second_change_ = 0;  ///< from 1 to 2, and from 2 to 3 sub-steps, relative
  double error_ = 0, rounding_ = 0;
  std::vector<double> best_;

  bool second_order() const;
};

}  // namespace assay
