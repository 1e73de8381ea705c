// SPDX-License-Identifier: BSD-3-Clause
// Vectors and tensors in the plane, as arrays.
#pragma once

#include <array>

#include "harness/numeric/tensor.hpp"

namespace assay {

using Point = std::array<double, 2>;
using Plane = std::array<double, 4>;  ///< a tensor's components 11, 12, 21, 22

inline Plane product(const Plane& a, const Plane& b) {
  return {a[0] * b[0] + a[1] * b[2], a[0] * b[1] + a[1] * b[3], a[2] * b[0] + a[3] * b[2], a[2] * b[1] + a[3] * b[3]};
}
inline Plane transposed(const Plane& a) { return {a[0], a[2], a[1], a[3]}; }
inline Plane rotation(double c, double s) { return {c, -s, s, c}; }
inline Point times(const Plane& a, const Point& x) { return {a[0] * x[0] + a[1] * x[1], a[2] * x[0] + a[3] * x[1]}; }

inline Plane in_plane(const Tensor& s) { return {s(0, 0), s(0, 1), s(1, 0), s(1, 1)}; }
inline Point in_plane(const Vector3& v) { return {v.x(), v.y()}; }
/// With 33.
inline std::array<double, 5> plane_stress(const Tensor& s) { return {s(0, 0), s(0, 1), s(1, 0), s(1, 1), s(2, 2)}; }

}  // namespace assay
