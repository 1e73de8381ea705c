// SPDX-License-Identifier: BSD-3-Clause
// Boxes along the axes around a scene's body.
#pragma once

#include <algorithm>

#include "drivers/scene/scene.hpp"

namespace assay::drivers {

template <int Dim>
struct BoxOf {
  std::array<double, Dim> lower{}, upper{};  ///< corners [m]

  /// Grows to hold a place.
  void hold(const Vector3& x) {
    for (std::size_t d = 0; d < Dim; ++d) {
      lower[d] = std::min(lower[d], x[static_cast<int>(d)]);
      upper[d] = std::max(upper[d], x[static_cast<int>(d)]);
    }
  }
  /// Grows to hold all places of its way along v for a time t.
  void move(const std::array<double, Dim>& v, double t) {
    for (std::size_t d = 0; d < Dim; ++d) {
      lower[d] += std::min(0.0, v[d] * t);
      upper[d] += std::max(0.0, v[d] * t);
    }
  }
  /// 2^Dim of them; in the plane Z = 0.
  std::vector<Vector3> corners() const {
    std::vector<Vector3> all;
    for (std::size_t k = 0; k < std::size_t{1} << Dim; ++k) {
      Vector3 x = Vector3::Zero();
      for (std::size_t d = 0; d < Dim; ++d)  // the last axis fastest
        x[static_cast<int>(d)] = k >> (Dim - 1 - d) & 1 ? upper[d] : lower[d];
      all.push_back(x);
    }
    return all;
  }
};
using Box = BoxOf<2>;

/// Around the body in its own frame: the ring's, the vortex's, or the body's own corners.
template <int Dim = 2>
BoxOf<Dim> body_box(const Scene& scene);

/// Around all places where the body is from 0 to time.end, as the scene's frame sees it.
template <int Dim = 2>
BoxOf<Dim> swept_box(const Scene& scene);

}  // namespace assay::drivers
