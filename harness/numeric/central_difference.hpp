// SPDX-License-Identifier: BSD-3-Clause
// First derivative by the eighth-order central difference.
#pragma once

#include <type_traits>

namespace assay {

constexpr int central_reach = 4;  ///< neighbours on either side

/// d f / d x at 0 from f(k), the value at x = k step, k = -4 .. 4.
auto central_difference(const auto& f, double step) {
  constexpr double weights[central_reach] = {4.0 / 5, -1.0 / 5, 4.0 / 105, -1.0 / 280};
  using Value = std::decay_t<decltype(f(0))>;
  Value sum = weights[0] / step * (f(1) - f(-1));
  for (int k = 2; k <= central_reach; ++k) sum += weights[k - 1] / step * (f(k) - f(-k));
  return sum;
}

}  // namespace assay
