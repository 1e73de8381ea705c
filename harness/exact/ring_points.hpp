// SPDX-License-Identifier: BSD-3-Clause
// Fixed reference points of a ring, grouped by radius: what depends on R alone is computed once for each radius.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace assay {

struct RingPoints {
  std::vector<double> radius;                ///< distinct radii, ascending [m]
  std::vector<std::uint32_t> ring;           ///< of each point: index of its radius
  std::vector<double> cos_theta, sin_theta;  ///< of each point: reference angle Theta

  RingPoints() = default;
  /// X, Y: reference positions [m].
  RingPoints(std::span<const double> X, std::span<const double> Y);
};

}  // namespace assay
