// SPDX-License-Identifier: BSD-3-Clause
// Nodal fields on a local, ghosted extent of the grid.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>
#include <span>

#include "mpm/data/pack.hpp"
#include "mpm/grid/node_box.hpp"

namespace assay::mpm {

/// `Components` interleaved values a node, in packs: value c of node i is data()[i * stride + c]; what is left of a
/// pack is zero. Memory that has not been written takes none of the machine's.
template <int Components>
class GridField {
 public:
  static constexpr int components = Components;
  static constexpr int stride = pack_size(Components);

  void allocate(std::size_t nodes) {
    size_ = nodes * stride;
    values_.reset(static_cast<double*>(std::calloc(std::max<std::size_t>(size_, 1), sizeof(double))));
    if (!values_) throw std::bad_alloc();
  }
  void zero() { std::fill_n(values_.get(), size_, 0.0); }
  void zero(std::span<const NodeRange> runs) {
    for (const NodeRange& run : runs) std::fill(node(run.first), node(run.end), 0.0);
  }
  void copy(const GridField& from, std::span<const NodeRange> runs) {
    for (const NodeRange& run : runs) std::copy(from.node(run.first), from.node(run.end), node(run.first));
  }

  /// Sums of ghost nodes into their owners, and owners back to ghosts: nothing to do in one process.
  void reduce_ghosts() {}
  void update_ghosts() {}

  double* node(std::size_t i) { return values_.get() + i * stride; }
  const double* node(std::size_t i) const { return values_.get() + i * stride; }
  double* data() { return values_.get(); }
  const double* data() const { return values_.get(); }
  std::size_t nodes() const { return size_ / stride; }
  std::size_t bytes() const { return size_ * sizeof(double); }

 private:
  struct Free {
    void operator()(double* memory) const { std::free(memory); }
  };
  std::unique_ptr<double[], Free> values_;
  std::size_t size_ = 0;
};

}  // namespace assay::mpm
