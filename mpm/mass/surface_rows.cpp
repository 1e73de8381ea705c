// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/mass/surface_rows.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "mpm/mass/mass_matrix.hpp"

namespace assay::mpm {

namespace {

/// Particles of the cell above each node.
template <int Dim>
std::vector<std::uint32_t> particles_in_cells(const Setup<Dim>& setup) {
  std::vector<std::uint32_t> count(setup.grid.nodes(), 0);
  for (std::size_t p = 0; p < setup.seeds.size(); ++p) {
    std::size_t cell = 0;
    for (int d = Dim; d-- > 0;) {
      const auto axis = static_cast<std::size_t>(d);
      const double along = (setup.seeds.X[axis][p] - setup.grid.coordinate(d, 0)) / setup.grid.spacing;
      const std::int32_t last = setup.grid.count[axis] - 1;
      const auto at = static_cast<std::int32_t>(std::clamp(std::floor(along), 0.0, static_cast<double>(last)));
      cell = cell * static_cast<std::size_t>(setup.grid.count[axis]) + static_cast<std::size_t>(at);
    }
    ++count[cell];
  }
  return count;
}

/// Of the numbers of each node those of the cells from `reach` below it to `reach` above it, by `join`, axis by axis.
template <int Dim>
std::vector<std::uint32_t> joined(std::vector<std::uint32_t> cells, const GridGeometry<Dim>& grid, int reach,
                                  const auto& join) {
  std::size_t stride = 1;
  for (std::size_t d = 0; d < Dim; ++d) {
    const auto count = static_cast<std::int64_t>(grid.count[d]);
    std::vector<std::uint32_t> next(cells.size(), 0);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::int64_t at = static_cast<std::int64_t>(i / stride) % count;
      const std::int64_t first = at - reach, last = at + reach - 1;
      const auto cell = [&](std::int64_t k) {  // beyond the grid there are none
        return k < 0 || k >= count ? 0U
                                   : cells[static_cast<std::size_t>(static_cast<std::int64_t>(i) +
                                                                    (k - at) * static_cast<std::int64_t>(stride))];
      };
      next[i] = cell(first);
      for (std::int64_t k = first + 1; k <= last; ++k) next[i] = join(next[i], cell(k));
    }
    cells = std::move(next);
    stride *= static_cast<std::size_t>(grid.count[d]);
  }
  return cells;
}

}  // namespace

template <int Dim>
std::size_t mass_row_bytes(const Setup<Dim>& setup) {
  const int across = mass_nodes_across<Dim>(setup.method);
  return across == 0 ? 0 : MassStencil<Dim>::entries(across) * sizeof(double);
}

template <int Dim>
std::size_t nodes_with_mass_rows(const Setup<Dim>& setup) {
  const int across = mass_nodes_across<Dim>(setup.method);
  if (across == 0) return 0;
  if (Dim == 2) return setup.grid.nodes();
  const std::vector<std::uint32_t> cells = particles_in_cells(setup);
  const int reach = (across + 1) / 2;
  const auto fewest = joined(cells, setup.grid, reach, [](auto a, auto b) { return std::min(a, b); });
  const auto most = joined(cells, setup.grid, reach, [](auto a, auto b) { return std::max(a, b); });
  const std::uint32_t full = *std::ranges::max_element(cells);
  std::size_t nodes = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) nodes += most[i] > 0 && fewest[i] < full ? 1 : 0;
  return nodes;
}

template std::size_t mass_row_bytes(const Setup<ASSAY_DIMENSION>&);
template std::size_t nodes_with_mass_rows(const Setup<ASSAY_DIMENSION>&);

}  // namespace assay::mpm
