// SPDX-License-Identifier: BSD-3-Clause
// What a particle gives to nodes or takes from them, K components at once.
#pragma once

#include "mpm/grid_field.hpp"

namespace assay::mpm {

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

}  // namespace assay::mpm
