// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/judge.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace assay::check {

Limit limit_of(const std::array<double, 3>& e) {
  const double largest = *std::max_element(e.begin(), e.end());
  if (!std::isfinite(e[0] + e[1] + e[2])) return {INFINITY, {}};
  if (largest <= own_precision) return {largest, {}};
  const double first = e[0] - e[1], second = e[1] - e[2];
  if (!(second > 0 && first > falling * second && e[2] < fallen * e[0])) return {e[2], {}};
  return {std::abs(e[2] - second * second / (first - second)), std::log2(first / second)};
}

std::string rounded(double value, int digits) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

std::string how(const Limit& limit, const std::array<double, 3>& e, int steps) {
  if (limit.order) {
    return "converges with order " + rounded(*limit.order) + " in the step: " + rounded(e[0]) + " at " +
           std::to_string(steps) + " steps, " + rounded(e[2]) + " at " + std::to_string(4 * steps);
  }
  if (limit.value <= exact_error) return "exact for every step length";
  if (limit.value <= own_precision) return "to the model's own precision, " + rounded(limit.value);
  return "off by " + rounded(limit.value) + " of the largest stress, for every step length";
}

std::string percent(double share) {
  char text[64];
  std::snprintf(text, sizeof text, share < 0.1 ? "%.2g %%" : share < 1e4 ? "%.0f %%" : "%.1e %%", 100 * share);
  return text;
}

}  // namespace assay::check
