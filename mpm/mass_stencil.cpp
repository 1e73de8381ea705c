// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/mass_stencil.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <numeric>

namespace assay::mpm {

namespace {

/// Nodes whose sums stay at hand while neighbour after neighbour is added.
constexpr std::size_t nodes_at_once = 256;

/// Steps along the axes from a node to its neighbour k of (2 nodes_across - 1)^Dim.
template <int Dim>
std::array<int, Dim> steps_to(int k, int nodes_across) {
  const int span = 2 * nodes_across - 1;
  std::array<int, Dim> steps{};
  for (int& step : steps) {
    step = k % span - (nodes_across - 1);
    k /= span;
  }
  return steps;
}

}  // namespace

template <int Dim>
std::size_t MassStencil<Dim>::entries(int nodes_across) {
  std::size_t product = 1;
  for (int d = 0; d < Dim; ++d) product *= static_cast<std::size_t>(2 * nodes_across - 1);
  return product;
}

/// Column after column: x is 1 at nodes so far from each other that no two have a neighbour in common.
template <int Dim>
MassStencil<Dim>::MassStencil(const GridGeometry<Dim>& grid, int nodes_across, const Multiply& multiply,
                              Instructions instructions)
    : nodes_(grid.nodes()), nodes_across_(nodes_across), add_products_(add_products_of<Dim>(instructions)) {
  const int span = 2 * nodes_across - 1, neighbours = static_cast<int>(entries(nodes_across));
  GridField<Dim> x, y;
  x.allocate(nodes_);
  y.allocate(nodes_);
  neighbours_.resize(static_cast<std::size_t>(neighbours));
  for (int k = 0; k < neighbours; ++k) {
    std::ptrdiff_t stride = 1;
    const std::array<int, Dim> steps = steps_to<Dim>(k, nodes_across);
    for (std::size_t d = 0; d < Dim; ++d) {
      neighbours_[static_cast<std::size_t>(k)].offset += steps[d] * stride;
      stride *= grid.count[d];
    }
    neighbours_[static_cast<std::size_t>(k)].steps = steps;
    neighbours_[static_cast<std::size_t>(k)].values.assign(nodes_, 0.0);
  }
  for (int colour = 0; colour < neighbours; ++colour) {
    const std::array<int, Dim> rest = steps_to<Dim>(colour, nodes_across);
    const auto column_of = [&](std::size_t i, std::array<int, Dim>& steps) {  // the neighbour of i that has this colour
      for (std::size_t d = 0; d < Dim; ++d) {
        const int at = static_cast<int>(i % static_cast<std::size_t>(grid.count[d]));
        i /= static_cast<std::size_t>(grid.count[d]);
        const int distance = ((rest[d] + nodes_across - 1 - at) % span + span) % span;
        steps[d] = distance < nodes_across ? distance : distance - span;
        if (at + steps[d] < 0 || at + steps[d] >= grid.count[d]) return false;
      }
      return true;
    };
    std::array<int, Dim> steps;
    for (std::size_t i = 0; i < nodes_; ++i) {
      x.node(i)[0] =
          column_of(i, steps) && std::all_of(steps.begin(), steps.end(), [](int s) { return s == 0; }) ? 1 : 0;
    }
    multiply(x, y);
    for (std::size_t i = 0; i < nodes_; ++i) {
      if (y.node(i)[0] == 0 || !column_of(i, steps)) continue;
      int k = 0;
      for (std::size_t d = Dim; d-- > 0;) k = k * span + steps[d] + nodes_across - 1;
      neighbours_[static_cast<std::size_t>(k)].values[i] = y.node(i)[0];
    }
  }
  find_pieces();
}

/// No longer than what stays at hand while neighbour after neighbour is added.
template <int Dim>
void MassStencil<Dim>::find_pieces() {
  const std::vector<double>& own = neighbours_[neighbours_.size() / 2].values;
  for (std::size_t i = 0; i < nodes_; ++i) {
    if (own[i] == 0) continue;
    if (pieces_.empty() || pieces_.back().end != i || i - pieces_.back().begin == nodes_at_once)
      pieces_.push_back({i, i});
    ++pieces_.back().end;
  }
}

template <int Dim>
std::array<std::vector<double>, Dim> MassStencil<Dim>::means() const {
  std::array<std::vector<double>, Dim> means;
  for (auto& mean : means) mean.assign(static_cast<std::size_t>(nodes_across_), 0.0);
  double all = 0;
  for (const Neighbour& neighbour : neighbours_) {
    const double sum = std::accumulate(neighbour.values.begin(), neighbour.values.end(), 0.0);
    all += sum;
    for (std::size_t d = 0; d < Dim; ++d) {
      const int step = neighbour.steps[d];
      means[d][static_cast<std::size_t>(std::abs(step))] += step == 0 ? sum : 0.5 * sum;
    }
  }
  for (auto& mean : means) {
    for (double& share : mean) share /= all;
  }
  return means;
}

template <int Dim>
void MassStencil<Dim>::multiply(const GridField<Dim>& x, GridField<Dim>& y, int threads) const {
  constexpr std::size_t S = GridField<Dim>::stride;
  y.zero();
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1)
  for (std::size_t k = 0; k < pieces_.size(); ++k) {
    const Piece& piece = pieces_[k];
    for (const Neighbour& neighbour : neighbours_) {
      const auto before = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, -neighbour.offset));
      const auto after = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, neighbour.offset));
      const std::size_t first = std::max(piece.begin, before);
      const std::size_t last = std::min(piece.end, nodes_ - std::min(nodes_, after));
      if (first >= last) continue;
      add_products_(
          {neighbour.values.data() + first, x.data() + (first + after - before) * S, y.node(first), last - first});
    }
  }
}

template class MassStencil<2>;
template class MassStencil<3>;

}  // namespace assay::mpm
