// SPDX-License-Identifier: BSD-3-Clause
// Nodal fields on a local, ghosted extent of the grid.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "mpm/pack.hpp"

namespace assay::mpm {

/// `Components` interleaved values a node, in packs: value c of node i is data()[i * stride + c]; what is left of a
/// pack is zero.
template <int Components>
class GridField {
 public:
  static constexpr int components = Components;
  static constexpr int stride = pack_size(Components);

  void allocate(std::size_t nodes) { values_.assign(nodes * stride, 0.0); }
  void zero() { std::fill(values_.begin(), values_.end(), 0.0); }

  /// Sums of ghost nodes into their owners, and owners back to ghosts: nothing to do in one process.
  void reduce_ghosts() {}
  void update_ghosts() {}

  double* node(std::size_t i) { return values_.data() + i * stride; }
  const double* node(std::size_t i) const { return values_.data() + i * stride; }
  double* data() { return values_.data(); }
  const double* data() const { return values_.data(); }
  std::size_t nodes() const { return values_.size() / stride; }
  std::size_t bytes() const { return values_.size() * sizeof(double); }

 private:
  std::vector<double> values_;
};

}  // namespace assay::mpm
