// SPDX-License-Identifier: BSD-3-Clause
// The corners of a particle's domain, as the column `corners` keeps them.
#pragma once

#include <cmath>

#include "mpm/basis/basis.hpp"

namespace assay::mpm {

/// x_c, first direction fastest: corner c is on the upper side of direction d where bit d of c is set [m].
template <int Dim>
using Corners = std::array<Vec<Dim>, 1 << Dim>;

template <int Dim>
inline constexpr int corner_components = Dim << Dim;

/// x_c = x + sum_d +-r_d, where column d of r is half edge d of the parallelepiped [m].
template <int Dim>
ASSAY_INLINE Corners<Dim> corners_of(const Vec<Dim>& x, const Mat<Dim>& r) {
  Corners<Dim> corners;
  for (std::size_t c = 0; c < corners.size(); ++c) {
    corners[c] = x;
    for (std::size_t d = 0; d < Dim; ++d) {
      for (std::size_t i = 0; i < Dim; ++i) corners[c][i] += (c >> d & 1) ? r[i * Dim + d] : -r[i * Dim + d];
    }
  }
  return corners;
}

/// Of Q_c, the multilinear function that is 1 at corner c: its average and that of its gradient over the domain.
template <int Dim>
struct CornerAverage {
  std::array<double, 1 << Dim> value;
  std::array<Vec<Dim>, 1 << Dim> gradient;  ///< [1/m]
  double volume = 0;                        ///< of the domain; not above 0 where it is turned inside out [m^Dim]
};

/// With x = m + a xi + b eta + c xi eta, J = J0 + J1 xi + J2 eta: J0 = a x b, J1 = a x c, J2 = c x b, the area is 4 J0
/// and the average of Q_c is 1/4 + (xi_c J1 + eta_c J2) / (12 J0). int grad Q_c is half the diagonal between the
/// neighbours of corner c, turned outward. Sadeghirad, Brannon and Guilkey (2013), in another order of the corners.
ASSAY_INLINE CornerAverage<2> average_over(const Corners<2>& x) {
  CornerAverage<2> found;
  const double ax = x[3][0] - x[0][0], ay = x[3][1] - x[0][1];  // diagonals: from 0 to 3, from 1 to 2
  const double bx = x[2][0] - x[1][0], by = x[2][1] - x[1][1];
  const double cx = x[0][0] - x[1][0] - x[2][0] + x[3][0], cy = x[0][1] - x[1][1] - x[2][1] + x[3][1];
  const double ux = ax - bx, uy = ay - by, vx = ax + bx, vy = ay + by;  // 4 a and 4 b
  const double area = found.volume = 0.5 * (ax * by - ay * bx), s = 0.5 / area;
  const double tilt1 = (ux * cy - uy * cx) / (48 * area), tilt2 = (cx * vy - cy * vx) / (48 * area);
  found.value = {0.25 - tilt1 - tilt2, 0.25 + tilt1 - tilt2, 0.25 - tilt1 + tilt2, 0.25 + tilt1 + tilt2};
  found.gradient = {{{-s * by, s * bx}, {s * ay, -s * ax}, {-s * ay, s * ax}, {s * by, -s * bx}}};
  return found;
}

/// By 2 x 2 x 2 Gauss points, exact for what is integrated: of degree 3 in each direction.
ASSAY_INLINE CornerAverage<3> average_over(const Corners<3>& x) {
  CornerAverage<3> found;
  found.value.fill(0);
  for (auto& gradient : found.gradient) gradient.fill(0);
  const double point = 1 / std::sqrt(3.0);
  const auto side = [](std::size_t c, std::size_t d) { return (c >> d & 1) ? 1.0 : -1.0; };
  for (std::size_t q = 0; q < 8; ++q) {
    std::array<double, 8> Q;
    std::array<Vec<3>, 8> slope;  // d Q_c / d xi
    Mat<3> J{};                   // d x / d xi
    for (std::size_t c = 0; c < 8; ++c) {
      Vec<3> f;
      for (std::size_t d = 0; d < 3; ++d) f[d] = 0.5 * (1 + side(c, d) * side(q, d) * point);
      Q[c] = f[0] * f[1] * f[2];
      for (std::size_t d = 0; d < 3; ++d) {
        slope[c][d] = 0.5 * side(c, d) * f[(d + 1) % 3] * f[(d + 2) % 3];
        for (std::size_t i = 0; i < 3; ++i) J[i * 3 + d] += x[c][i] * slope[c][d];
      }
    }
    const double det = determinant<3>(J);
    const Mat<3> cofactor = inverse_transpose<3>(J, 1);  // det times the inverse's transpose
    found.volume += det;
    for (std::size_t c = 0; c < 8; ++c) {
      found.value[c] += Q[c] * det;
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t d = 0; d < 3; ++d) found.gradient[c][i] += cofactor[i * 3 + d] * slope[c][d];
      }
    }
  }
  for (std::size_t c = 0; c < 8; ++c) {
    found.value[c] /= found.volume;
    for (double& component : found.gradient[c]) component /= found.volume;
  }
  return found;
}

}  // namespace assay::mpm
