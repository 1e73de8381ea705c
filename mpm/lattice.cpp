// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/lattice.hpp"

#include <cmath>

namespace assay::mpm {

namespace {

/// A bound that is a multiple of h up to rounding counts as that multiple.
constexpr double rounding = 1e-9;

std::int32_t cell_below(double x, double h) { return static_cast<std::int32_t>(std::floor(x / h + rounding)); }
std::int32_t cell_above(double x, double h) { return static_cast<std::int32_t>(std::ceil(x / h - rounding)); }

}  // namespace

Seeds<2> cartesian_lattice(const std::array<double, 2>& lower, const std::array<double, 2>& upper, double spacing,
                           const std::array<int, 2>& per_cell,
                           const std::function<Fate(const std::array<double, 2>&)>& fate) {
  Seeds<2> seeds;
  // (2 i + 1) half: the same |X| to the last bit on both sides of the origin
  for (std::size_t d = 0; d < 2; ++d) seeds.half_size[d] = 0.5 * spacing / per_cell[d];
  const auto coordinate = [&](std::size_t d, std::int32_t cell, int k) {
    return (2.0 * (static_cast<double>(cell) * per_cell[d] + k) + 1) * seeds.half_size[d];
  };
  for (std::int32_t j = cell_below(lower[1], spacing); j < cell_above(upper[1], spacing); ++j) {
    for (std::int32_t i = cell_below(lower[0], spacing); i < cell_above(upper[0], spacing); ++i) {
      for (int b = 0; b < per_cell[1]; ++b) {
        for (int a = 0; a < per_cell[0]; ++a) {
          const std::array<double, 2> X{coordinate(0, i, a), coordinate(1, j, b)};
          if (X[0] < lower[0] || X[0] > upper[0] || X[1] < lower[1] || X[1] > upper[1]) continue;
          const Fate what = fate(X);
          if (what == Fate::held) seeds.held.push_back(X);
          if (what != Fate::stepped) continue;
          seeds.X[0].push_back(X[0]);
          seeds.X[1].push_back(X[1]);
        }
      }
    }
  }
  return seeds;
}

GridGeometry<2> grid_around(const std::array<double, 2>& lower, const std::array<double, 2>& upper, double spacing,
                            int margin) {
  GridGeometry<2> grid;
  grid.spacing = spacing;
  for (std::size_t d = 0; d < 2; ++d) {
    grid.first[d] = cell_below(lower[d], spacing) - margin;
    grid.count[d] = cell_above(upper[d], spacing) + margin - grid.first[d] + 1;
  }
  return grid;
}

}  // namespace assay::mpm
