// SPDX-License-Identifier: BSD-3-Clause
// Extrapolation of results of 1, 2, 3 ... sub-steps to a step of length zero (Aitken and Neville; Hairer, Norsett and
// Wanner, Solving Ordinary Differential Equations I, II.9).
#pragma once

#include <array>
#include <span>
#include <vector>

namespace assay {

/// A tableau for errors in powers of h, and one for errors in powers of h^2, which a symmetric increment has. It is not
/// known of a foreign increment, so both are kept; the latter counts where the results of 1, 2, 3 sub-steps approach
/// each other like 1, 1/4, 1/9.
class Extrapolation {
 public:
  static constexpr int most_columns = 6;

  void clear() { rows_ = 0; }

  /// The result of the next number of sub-steps: 1, 2, 3 ... `scales`: what errors are measured against.
  void add(std::span<const double> result, std::span<const double> scales);

  int columns() const { return rows_; }
  double error() const { return error_; }  ///< estimated, relative; infinite with one column
  /// What rounding of the results leaves, relative, whatever the number of columns.
  double rounding() const { return rounding_; }
  const std::vector<double>& best() const { return best_; }

 private:
  using Row = std::array<std::vector<double>, most_columns>;
  int rows_ = 0;
  std::array<Row, 2> last_;  ///< of the tableau of h, and of h^2
  Row next_;
  double first_change_ = 0, second_change_ = 0;  ///< from 1 to 2, and from 2 to 3 sub-steps, relative
  double error_ = 0, rounding_ = 0;
  std::vector<double> best_;

  bool even_powers() const;
};

}  // namespace assay
