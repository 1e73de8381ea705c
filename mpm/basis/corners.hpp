// SPDX-License-Identifier: BSD-3-Clause
// The corners of a particle's domain, as the column `corners` keeps them, and where they lie among the nodes of the
// grid.
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

/// Of one particle: share[n][c] = N_n(x_c) of node n of the corner's cell.
template <int Dim>
struct CornerCells {
  static constexpr int corners = 1 << Dim;
  Pack<corners> fraction[Dim];
  std::array<std::array<double, corners>, corners> share;
  std::array<std::int32_t, corners> node;  ///< the lowest of each cell
};

template <int Dim>
class CornerPlaces {
 public:
  static constexpr int corners = 1 << Dim;
  static constexpr std::size_t bytes = Dim * corners * sizeof(double);  ///< a particle

  CornerPlaces(const GridGeometry<Dim>& grid, std::size_t particles) : locator_(grid), along_(particles) {
    for (std::size_t n = 0; n < corners; ++n) {
      for (std::size_t d = 0; d < Dim; ++d) offsets_[n] += (n >> d & 1) ? locator_.stride[d] : 0;
    }
  }

  double spacing() const { return locator_.spacing; }

  /// x[d]: of the corners [m]. False outside the grid or where one is no number.
  ASSAY_INLINE bool place(std::size_t p, const Pack<corners>* x) {
    bool inside = true;
    for (std::size_t d = 0; d < Dim; ++d) {
      auto& along = along_[p][d];
      store<corners>(along.data(), x[d] * locator_.inverse_spacing - locator_.first[d]);
      for (const double at : along) inside &= at >= 0 && at < locator_.last_cell[d];
    }
    if (!inside) along_[p] = {};
    return inside;
  }

  /// Of the corners, in cells from the grid's first node.
  ASSAY_INLINE Pack<corners> along(std::size_t p, std::size_t d) const {
    Pack<corners> found;
    load<corners>(found, along_[p][d].data());
    return found;
  }

  /// Node n of the cell of a corner, from its lower node on; S numbers a node.
  template <int S, class Number>
  ASSAY_INLINE Number* node_of(Number* lower, std::size_t n) const {
    return lower + offsets_[n] * S;
  }

  ASSAY_INLINE void find(std::size_t p, CornerCells<Dim>& cells) const {
    cells.node.fill(0);
    Pack<corners> share[corners];
    share[0] = 1 - Pack<corners>{};
    for (std::size_t d = 0; d < Dim; ++d) {
      Pack<corners> lower;
      const Pack<corners> at = along(p, d);
      std::array<std::int32_t, corners> cell;
      truncate<corners>(at, cell, lower);
      const Pack<corners> f = at - lower, g = 1 - f;
      cells.fraction[d] = f;
      for (std::size_t c = 0; c < corners; ++c) cells.node[c] += cell[c] * locator_.stride[d];
      for (std::size_t n = 0; n < std::size_t{1} << d; ++n) {
        share[n + (1 << d)] = share[n] * f;
        share[n] = share[n] * g;
      }
    }
    for (std::size_t n = 0; n < corners; ++n) store<corners>(cells.share[n].data(), share[n]);
  }

  /// Which nodes particles begin to end - 1 reach.
  ASSAY_INLINE void reach(std::size_t begin, std::size_t end, NodeBox<Dim>& nodes) const {
    for (std::size_t d = 0; d < Dim; ++d) {
      Extremes<corners> of_corners(locator_.last_cell[d]);
      for (std::size_t p = begin; p < end; ++p) {
        for (std::size_t c = 0; c < corners; ++c) of_corners.include(c, along_[p][d][c]);
      }
      nodes.first[d] = static_cast<std::int32_t>(of_corners.lowest());
      nodes.end[d] = static_cast<std::int32_t>(of_corners.highest()) + 2;
    }
  }

 private:
  Locator<Dim> locator_;
  std::array<std::ptrdiff_t, corners> offsets_{};
  std::vector<std::array<std::array<double, corners>, Dim>> along_;  ///< cell coordinates of the corners: [d][c]
};

}  // namespace assay::mpm
