// SPDX-License-Identifier: BSD-3-Clause
// Pieces of the grid: boxes of nodes, and the runs of neighbours that they are made of.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace assay::mpm {

/// Nodes first to end - 1 in each direction, by their local indices; none at first.
template <int Dim>
struct NodeBox {
  std::array<std::int32_t, Dim> first, end;

  NodeBox() {
    first.fill(std::numeric_limits<std::int32_t>::max());
    end.fill(0);
  }
  void include(const NodeBox& other) {
    for (std::size_t d = 0; d < Dim; ++d) {
      first[d] = std::min(first[d], other.first[d]);
      end[d] = std::max(end[d], other.end[d]);
    }
  }
};

/// Nodes first to end - 1 in the order of the grid, along the first direction.
struct NodeRange {
  std::size_t first = 0, end = 0;
};

/// body(line) for the lines of nodes along the first direction in which the box has some, in the order of the grid.
template <int Dim, class Body>
void for_lines(const NodeBox<Dim>& box, const std::array<std::int32_t, Dim>& count, const Body& body) {
  const auto line_at = [&](std::int32_t y, std::int32_t z) {
    return static_cast<std::size_t>(z) * static_cast<std::size_t>(count[1]) + static_cast<std::size_t>(y);
  };
  if constexpr (Dim == 2) {
    for (std::int32_t y = box.first[1]; y < box.end[1]; ++y) body(line_at(y, 0));
  } else {
    for (std::int32_t z = box.first[2]; z < box.end[2]; ++z) {
      for (std::int32_t y = box.first[1]; y < box.end[1]; ++y) body(line_at(y, z));
    }
  }
}

}  // namespace assay::mpm
