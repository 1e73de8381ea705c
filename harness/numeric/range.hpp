// SPDX-License-Identifier: BSD-3-Clause
// Intervals, and what a number may be.
#pragma once

#include <limits>
#include <string>

namespace assay {

struct Interval {
  double lower = 0, upper = 0;
  double width() const { return upper - lower; }
};

/// A whole number is at most 2^53 in size.
struct Range {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  bool lower_open = false, upper_open = false;
  bool whole = false;
  /// "greater than 0", "from 1 to 16"; empty for any number.
  std::string text() const;
  bool holds(double value) const;
};

inline constexpr Range positive{.lower = 0, .lower_open = true};

}  // namespace assay
