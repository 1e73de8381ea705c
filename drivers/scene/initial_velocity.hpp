// SPDX-License-Identifier: BSD-3-Clause
// The velocity with which a body that is left to itself begins.
#pragma once

#include "drivers/scene/scene.hpp"

namespace assay::drivers {

/// L = D + W: L11, L12, L21, L22 [1/s].
inline std::array<double, 4> gradient_of(const InitialVelocity& v) {
  return {v.stretching[0], v.stretching[2] - v.spin, v.stretching[2] + v.spin, v.stretching[1]};
}

/// v = velocity + L X [m/s].
inline std::array<double, 2> velocity_at(const InitialVelocity& v, double X, double Y) {
  const std::array<double, 4> L = gradient_of(v);
  return {v.velocity[0] + L[0] * X + L[1] * Y, v.velocity[1] + L[2] * X + L[3] * Y};
}

}  // namespace assay::drivers
