// SPDX-License-Identifier: BSD-3-Clause
// Where a function of one variable that rises is zero.
#pragma once

#include <algorithm>

namespace assay {

/// Between lower, where it is not positive, and upper, where it is not negative: by Newton's steps from a guess, and by
/// halves where a step would leave what is left. To rounding. of(x): a pair of value and slope.
double rising_root(double lower, double upper, double guess, const auto& of) {
  constexpr int most_steps = 100;  // halves alone take 60
  double x = std::clamp(guess, lower, upper);
  for (int k = 0; k < most_steps; ++k) {
    const auto [value, slope] = of(x);
    double next = x - value / slope;
    if (value == 0 || next == x) break;
    (value < 0 ? lower : upper) = x;
    if (!(next > lower && next < upper)) next = 0.5 * (lower + upper);
    if (next == lower || next == upper) break;
    x = next;
  }
  return x;
}

}  // namespace assay
