// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

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

}  // namespace assay::mpm
