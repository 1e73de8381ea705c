// SPDX-License-Identifier: BSD-3-Clause
// From what is measured to a verdict: whether an error that is found at N, 2N and 4N steps is the step's or the
// model's, and whether a body that is turned and not deformed keeps its stress.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "harness/check/battery.hpp"
#include "harness/numeric/number_text.hpp"
#include "harness/numeric/tensor.hpp"

namespace assay::check {

inline constexpr double exact_error = 1e-11;    ///< rounding of a history in double precision
inline constexpr double own_precision = 2e-5;   ///< of a model that computes in single precision
inline constexpr double turn_precision = 1e-4;  ///< of such a model after the steps of a turn
inline constexpr double converging_limit =
    5e-3;                               ///< of correct increments at most 8e-5 is left, of wrong ones at least 4e-2
inline constexpr double falling = 1.3;  ///< (e1 - e2) / (e2 - e3) of errors that have a limit to be found

inline constexpr double fallen = 0.7;  ///< e3 / e1 of errors that fall at all

/// Of errors that are found at N, 2N and 4N steps.
using Errors = std::array<double, 3>;

/// What remains of an error as the step goes to zero.
struct Limit {
  double value = 0;             ///< relative
  std::optional<double> order;  ///< at which the error falls; none where it does not depend on the step
  bool passes() const { return value <= converging_limit; }
};

/// The largest where all are within `own_precision`; by Aitken's extrapolation where they fall; else the last one.
Limit limit_of(const Errors& errors);

/// "exact", "to its own precision of 3e-7", "first order in the step: 2e-2 at 100 steps, 5e-3 at 400".
std::string how(const Limit& limit, const Errors& errors, int steps);

/// error_of(N), error_of(2N) and error_of(4N).
Errors at_halved_steps(int steps, const auto& error_of) {
  Errors errors{};
  for (int k = 0; k < 3; ++k) errors[static_cast<std::size_t>(k)] = error_of(steps << k);
  return errors;
}

/// Two digits.
inline std::string rounded(double value, int digits = 2) { return rounded_text(value, digits); }

/// "5.1 %", "110 %".
std::string percent(double share);

/// A test that says nothing of this material, and why.
TestResult left_out(std::string why);

TestResult passed(double measure, double threshold, std::string sentence);
TestResult failed(const char* cause, double measure, double threshold, std::string sentence);

/// Passes where the measure is no larger than the threshold, in the one sentence or the other.
TestResult judged(double measure, double threshold, std::string right, const char* cause, std::string wrong);

/// Of errors that have a limit; after `words`, and without a cause.
TestResult judged(const Errors& errors, const std::string& words, int steps);

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
  TestResult judged(const std::string& words, int steps) const;

 private:
  double worst() const;

  Errors errors_{};
  double change_of_size_ = 0;  ///< of the principal values, relative, at any number of steps
};

}  // namespace assay::check
