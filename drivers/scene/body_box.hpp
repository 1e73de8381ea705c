// SPDX-License-Identifier: BSD-3-Clause
// Boxes along the axes around a scene's body.
#pragma once

#include "drivers/scene/scene.hpp"

namespace assay::drivers {

struct Box {
  std::array<double, 2> lower{}, upper{};  ///< corners [m]
};

/// Around the body in its own frame: the ring's, or the body's own corners.
Box body_box(const Scene& scene);

/// Around all places where the body is from 0 to time.end, as the scene's frame sees it.
Box swept_box(const Scene& scene);

}  // namespace assay::drivers
