// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/space.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace assay::check {

bool Space::has(int component) const { return !is_plane_ || is_in_plane(component); }

Tensor Space::within(const Tensor& A) const {
  Tensor result = A;
  for (int c = 0; c < 9; ++c) {
    if (!has(c)) component(result, c) = 0;
  }
  return result;
}

Tensor Space::turn(double angle) const {
  if (is_plane_) return rotation_about_z(angle);
  return Eigen::AngleAxisd(angle, Vector3(1, 2, 3).normalized()).toRotationMatrix();
}

Tensor Space::stretch(double amplitude, double s) const {
  Tensor A, B;
  A << 1, 0.4, -0.3, 0.4, -0.5, 0.2, -0.3, 0.2, 0.3;
  B << -0.2, 0.5, 0.1, 0.5, 0.6, -0.4, 0.1, -0.4, -0.3;
  return within(Tensor::Identity() + amplitude * (std::sin(1.5 * std::numbers::pi * s) * A + s * s * B));
}

}  // namespace assay::check
