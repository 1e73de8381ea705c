// SPDX-License-Identifier: BSD-3-Clause
// How the passes reach columns and the weights that they share.
#pragma once

#include <array>

#include "mpm/kernels/kernel_state.hpp"

namespace assay::mpm {

/// Pointers to the components of a column.
template <int N, int Dim>
ASSAY_INLINE std::array<double*, N> components(KernelState<Dim>& s, Column which) {
  std::array<double*, N> pointers;
  for (int c = 0; c < N; ++c) pointers[static_cast<std::size_t>(c)] = s.column(which, c);
  return pointers;
}

template <std::size_t N>
ASSAY_INLINE std::array<double, N> load(const std::array<double*, N>& column, std::size_t p) {
  std::array<double, N> values;
  for (std::size_t c = 0; c < N; ++c) values[c] = column[c][p];
  return values;
}

/// Index of component (i, d) of the stress column: in plane strain 11, 12, 21, 22 come before 33.
template <int Dim>
constexpr std::size_t stress_index(std::size_t i, std::size_t d) {
  return i * Dim + d;
}

}  // namespace assay::mpm
