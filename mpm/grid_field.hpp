// SPDX-License-Identifier: BSD-3-Clause
// Nodal fields on a local, ghosted extent of the grid.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace assay::mpm {

/// `Components` interleaved values a node: value c of node i is data()[i * Components + c].
template <int Components>
class GridField {
 public:
  static constexpr int components = Components;

  void allocate(std::size_t nodes) { values_.assign(nodes * Components, 0.0); }
  void zero() { std::fill(values_.begin(), values_.end(), 0.0); }

  /// Sums of ghost nodes into their owners, and owners back to ghosts: nothing to do in one process.
  void reduce_ghosts() {}
  void update_ghosts() {}

  double* node(std::size_t i) { return values_.data() + i * Components; }
  const double* node(std::size_t i) const { return values_.data() + i * Components; }
  double* data() { return values_.data(); }
  const double* data() const { return values_.data(); }
  std::size_t nodes() const { return values_.size() / Components; }
  std::size_t bytes() const { return values_.size() * sizeof(double); }

 private:
  std::vector<double> values_;
};

}  // namespace assay::mpm
