// SPDX-License-Identifier: BSD-3-Clause
// Gauss-Legendre rules on [-1, 1].
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace assay {

struct GaussPoint {
  double at = 0, weight = 0;
};

/// So many points, exact to degree 2 count - 1; roots of the Legendre polynomial by Newton's method. Symmetric to the
/// last bit.
inline std::vector<GaussPoint> gauss_points(int count) {
  std::vector<GaussPoint> points(static_cast<std::size_t>(count));
  for (int k = 0; k < (count + 1) / 2; ++k) {
    double x = 2 * k + 1 == count ? 0 : std::cos(std::numbers::pi * (k + 0.75) / (count + 0.5)), slope = 1;
    for (int pass = 0; pass < 8; ++pass) {
      double previous = 1, value = x;  // P_0, P_1
      for (int n = 2; n <= count; ++n) {
        const double next = ((2 * n - 1) * x * value - (n - 1) * previous) / n;
        previous = value;
        value = next;
      }
      if (count == 1) value = x, previous = 1;
      slope = count * (x * value - previous) / (x * x - 1);
      x -= value / slope;
    }
    const double weight = 2 / ((1 - x * x) * slope * slope);
    points[static_cast<std::size_t>(k)] = {-x, weight};
    points[static_cast<std::size_t>(count - 1 - k)] = {x, weight};
  }
  return points;
}

/// Of N points, made once.
template <int N>
const std::array<GaussPoint, N>& gauss_rule() {
  static const std::array<GaussPoint, N> rule = [] {
    std::array<GaussPoint, N> points;
    std::ranges::copy(gauss_points(N), points.begin());
    return points;
  }();
  return rule;
}

}  // namespace assay
