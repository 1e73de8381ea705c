// SPDX-License-Identifier: BSD-3-Clause
// A table of rows of the mass matrix, to which particles add theirs.
#pragma once

#include <cstddef>
#include <cstdint>

namespace assay::mpm {

/// Rows of the matrix that are worked on together: of nodes i, i + 1, ... from a multiple of this on.
inline constexpr std::size_t rows_at_once = 4;

/// Where rows of the matrix lie, of which entry k of a node's is that of its neighbour k: by the steps to it along the
/// axes, the first fastest, each from 1 - nodes_across to nodes_across - 1.
struct MassRows {
  const std::uint32_t* group = nullptr;  ///< of each `rows_at_once` nodes, or `no_rows`
  const unsigned char* own = nullptr;    ///< of each node, whether it has a row
  double* values = nullptr;
  std::size_t entries = 0;
  static constexpr std::uint32_t no_rows = 0xffffffffu;

  bool holds(std::size_t i) const { return own[i] != 0; }
  /// Entry k at [k * rows_at_once].
  double* row(std::size_t i) const {
    return values + std::size_t{group[i / rows_at_once]} * entries * rows_at_once + i % rows_at_once;
  }
};

}  // namespace assay::mpm
