// SPDX-License-Identifier: BSD-3-Clause
// The corners of a particle's domain, as the column `corners` keeps them.
#pragma once

#include "mpm/basis/basis.hpp"

namespace assay::mpm {

/// x_c, first direction fastest: corner c is on the upper side of direction d where bit d of c is set [m].
template <int Dim>
using Corners = std::array<Vec<Dim>, 1 << Dim>;

template <int Dim>
inline constexpr int corner_components = Dim << Dim;

/// Bases whose domains are given by corners that move with the grid, one by one.
template <class B>
concept MovesCorners = requires {
  requires B::moves_corners;
};

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

}  // namespace assay::mpm
