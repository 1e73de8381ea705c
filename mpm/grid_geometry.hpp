// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace assay::mpm {

/// Nodes at multiples of the spacing h, from index `first` to `first + count - 1` in each direction.
template <int Dim>
struct GridGeometry {
  double spacing = 0;                     ///< h [m]
  std::array<std::int32_t, Dim> first{};  ///< global index of the first local node
  std::array<std::int32_t, Dim> count{};  ///< local nodes

  std::size_t nodes() const {
    std::size_t product = 1;
    for (const auto c : count) product *= static_cast<std::size_t>(c);
    return product;
  }
  double coordinate(int direction, std::int32_t local) const {
    return spacing * static_cast<double>(first[static_cast<std::size_t>(direction)] + local);
  }
};

}  // namespace assay::mpm
