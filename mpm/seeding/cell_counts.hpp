// SPDX-License-Identifier: BSD-3-Clause
// Which cell of a grid a coordinate belongs to.
#pragma once

#include <cmath>
#include <cstdint>

namespace assay::mpm {

/// A bound that is a multiple of h up to rounding counts as that multiple.
inline constexpr double multiple_rounding = 1e-9;

inline std::int32_t cell_below(double x, double h) {
  return static_cast<std::int32_t>(std::floor(x / h + multiple_rounding));
}
inline std::int32_t cell_above(double x, double h) {
  return static_cast<std::int32_t>(std::ceil(x / h - multiple_rounding));
}

}  // namespace assay::mpm
