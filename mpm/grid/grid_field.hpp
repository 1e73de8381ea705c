// SPDX-License-Identifier: BSD-3-Clause
// Nodal fields on a local, ghosted extent of the grid.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <new>
#include <span>

#include "mpm/data/simd.hpp"
#include "mpm/grid/grid_geometry.hpp"

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

  /// Sums of ghost nodes into their owners: nothing to do in one process.
  void reduce_ghosts() {}

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

/// Particles whose weights are made together.
inline constexpr std::size_t particles_at_once = 64;

/// A value and, for each direction, what goes with the slopes or moments of the weights in it.
template <int K, int Dim>
struct NodePacks {
  static constexpr int stride = GridField<K>::stride;
  Pack<stride> value{}, other[Dim]{};

  /// A, and the columns of B (G x Dim, row-major) in the last G components.
  template <int G>
  ASSAY_INLINE void set(const std::array<double, K>& A, const std::array<double, G * Dim>& B) {
    fill<stride>(value, A.data(), K);
    if constexpr (G > 0) {
      for (int d = 0; d < Dim; ++d) {
        double column[K] = {};
        for (int k = 0; k < G; ++k) column[K - G + k] = B[static_cast<std::size_t>(k * Dim + d)];
        fill<stride>(other[d], column, K);
      }
    }
  }

  /// The value, and of its first G components a row of B each.
  template <int G>
  ASSAY_INLINE void get(std::array<double, K>& A, std::array<double, G * Dim>& B) const {
    for (int k = 0; k < K; ++k) A[static_cast<std::size_t>(k)] = value[k];
    for (int k = 0; k < G; ++k) {
      for (int d = 0; d < Dim; ++d) B[static_cast<std::size_t>(k * Dim + d)] = other[d][k];
    }
  }
};

/// What several particles give to nodes.
template <int K, int Dim>
struct Given {
  static constexpr int stride = GridField<K>::stride;
  double value[particles_at_once][stride], other[Dim][particles_at_once][stride];

  template <bool WithOther>
  ASSAY_INLINE void get(std::size_t k, NodePacks<K, Dim>& packs) const {
    load<stride>(packs.value, value[k]);
    for (std::size_t d = 0; WithOther && d < Dim; ++d) load<stride>(packs.other[d], other[d][k]);
  }
};

/// What several particles take from nodes: K components, and the slopes of the first G of them.
template <int K, int G, int Dim>
struct Taken {
  double value[K][particles_at_once], slope[Dim][G == 0 ? 1 : G][particles_at_once];

  ASSAY_INLINE void set(std::size_t k, const NodePacks<K, Dim>& packs) {
    for (std::size_t c = 0; c < K; ++c) value[c][k] = packs.value[c];
    for (std::size_t d = 0; d < Dim; ++d) {
      for (std::size_t c = 0; c < G; ++c) slope[d][c][k] = packs.other[d][c];
    }
  }
};

}  // namespace assay::mpm
