// SPDX-License-Identifier: BSD-3-Clause
// A table of rows of the mass matrix, to which particles add theirs.
#pragma once

#include <cstddef>
#include <cstdint>

namespace assay::mpm {

/// Rows of the matrix that are worked on together: of nodes i, i + 1, ... from a multiple of this on. In space the
/// components of one node fill a pack.
template <int Dim>
inline constexpr std::size_t rows_at_once = Dim == 2 ? 4 : 1;

/// Where rows of the matrix lie, of which entry k of a node's is that of its neighbour k: by the steps to it along the
/// axes, the first fastest, each from 1 - nodes_across to nodes_across - 1.
template <int Dim>
struct MassRows {
  const std::uint32_t* group = nullptr;  ///< of each `rows_at_once` nodes, or `no_rows`
  const unsigned char* own = nullptr;    ///< of each node, whether it has a row
  double* values = nullptr;
  std::size_t entries = 0;
  static constexpr std::uint32_t no_rows = 0xffffffffu;

  bool holds(std::size_t i) const { return own[i] != 0; }
  /// Entry k at [k * rows_at_once].
  double* row(std::size_t i) const {
    constexpr std::size_t n = rows_at_once<Dim>;
    return values + std::size_t{group[i / n]} * entries * n + i % n;
  }
};

}  // namespace assay::mpm
