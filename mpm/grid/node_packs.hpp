// SPDX-License-Identifier: BSD-3-Clause
// What a particle gives to nodes or takes from them, K components at once.
#pragma once

#include "mpm/grid/grid_field.hpp"

namespace assay::mpm {

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
