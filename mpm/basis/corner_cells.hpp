// SPDX-License-Identifier: BSD-3-Clause
// Where the corners of the particles' domains lie among the nodes of the grid.
#pragma once

#include "mpm/basis/basis.hpp"
#include "mpm/basis/corners.hpp"

namespace assay::mpm {

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
