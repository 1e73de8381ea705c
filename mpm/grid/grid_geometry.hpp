// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace assay::mpm {

/// Nodes at multiples of the spacing h, shifted by a part of it, from index `first` to `first + count - 1` in each
/// direction.
template <int Dim>
struct GridGeometry {
  double spacing = 0;                     ///< h [m]
  std::array<std::int32_t, Dim> first{};  ///< global index of the first local node
  std::array<std::int32_t, Dim> count{};  ///< local nodes
  std::array<double, Dim> offset{};       ///< node k lies at (k + offset) h

  std::size_t nodes() const {
    std::size_t product = 1;
    for (const auto c : count) product *= static_cast<std::size_t>(c);
    return product;
  }
  double coordinate(int direction, std::int32_t local) const {
    const auto d = static_cast<std::size_t>(direction);
    return spacing * (static_cast<double>(first[d] + local) + offset[d]);
  }
};

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
