// SPDX-License-Identifier: BSD-3-Clause
// Boxes along the axes around a scene's body.
#pragma once

#include <algorithm>

#include "drivers/scene/scene.hpp"

namespace assay::drivers {

struct Box {
  std::array<double, 2> lower{}, upper{};  ///< corners [m]

  /// Grows to hold a place.
  void hold(const Vector3& x) {
    for (std::size_t d = 0; d < 2; ++d) {
      lower[d] = std::min(lower[d], x[static_cast<int>(d)]);
      upper[d] = std::max(upper[d], x[static_cast<int>(d)]);
    }
  }
  /// Grows to hold all places of its way along v for a time t.
  void move(const std::array<double, 2>& v, double t) {
    for (std::size_t d = 0; d < 2; ++d) {
      lower[d] += std::min(0.0, v[d] * t);
      upper[d] += std::max(0.0, v[d] * t);
    }
  }
};

/// Around the body in its own frame: the ring's, or the body's own corners.
Box body_box(const Scene& scene);

/// Around all places where the body is from 0 to time.end, as the scene's frame sees it.
Box swept_box(const Scene& scene);

}  // namespace assay::drivers
