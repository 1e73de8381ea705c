// SPDX-License-Identifier: BSD-3-Clause
// A body that is turned and not deformed: its stress turns along and keeps its principal values.
#pragma once

#include <array>
#include <string>

#include "harness/check/judge.hpp"
#include "harness/numeric/tensor.hpp"

namespace assay::check {

/// Stresses after a rotation in N, 2N and 4N steps, against what they should be.
class RigidTurn {
 public:
  /// level 0, 1, 2; `expected` has been turned; scale [Pa].
  void note(int level, const Tensor& found, const Tensor& expected, double scale);

  /// Exact at every number of steps; or turned by an angle that converges, the principal values kept at every one.
  bool passes() const { return exact() || (limit_of(errors_).passes() && keeps_size()); }
  bool exact() const { return worst() <= turn_precision; }
  bool keeps_size() const { return change_of_size_ <= turn_precision; }  ///< in steps that are rotations

  /// Measure, threshold, order, verdict and sentence, after `words`. steps: N.
  TestResult judged(const char* id, const std::string& words, int steps) const;

 private:
  double worst() const;

  std::array<double, 3> errors_{};
  double change_of_size_ = 0;  ///< of the principal values, relative, at any number of steps
};

}  // namespace assay::check
