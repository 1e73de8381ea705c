// SPDX-License-Identifier: BSD-3-Clause
// Whether an error that is found at N, 2N and 4N steps is the step's or the model's.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "harness/check/battery.hpp"

namespace assay::check {

inline constexpr double exact_error = 1e-11;    ///< rounding of a history in double precision
inline constexpr double own_precision = 2e-5;   ///< of a model that computes in single precision
inline constexpr double turn_precision = 1e-4;  ///< of such a model after the steps of a turn
inline constexpr double converging_limit =
    5e-3;                               ///< of correct increments at most 8e-5 is left, of wrong ones at least 4e-2
inline constexpr double falling = 1.3;  ///< (e1 - e2) / (e2 - e3) of errors that have a limit to be found

inline constexpr double fallen = 0.7;  ///< e3 / e1 of errors that fall at all

/// What remains of an error as the step goes to zero.
struct Limit {
  double value = 0;             ///< relative
  std::optional<double> order;  ///< at which the error falls; none where it does not depend on the step
  bool passes() const { return value <= converging_limit; }
};

/// Of errors at N, 2N, 4N steps: the largest where all are within `own_precision`; by Aitken's extrapolation where
/// they fall; else the last one.
Limit limit_of(const std::array<double, 3>& errors);

/// "exact", "to its own precision of 3e-7", "first order in the step: 2e-2 at 100 steps, 5e-3 at 400".
std::string how(const Limit& limit, const std::array<double, 3>& errors, int steps);

/// Two digits.
std::string rounded(double value, int digits = 2);

/// "5.1 %", "110 %".
std::string percent(double share);

}  // namespace assay::check
