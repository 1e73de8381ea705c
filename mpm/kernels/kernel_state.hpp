// SPDX-License-Identifier: BSD-3-Clause
// What the kernels see of a running simulation: plain numbers. They are compiled for several sets of instructions, and
// what stands here must be the same for all of them; Eigen's types need not be.
#pragma once

#include <array>
#include <concepts>
#include <memory>
#include <vector>

#include "mpm/data/columns.hpp"
#include "mpm/grid/grid_field.hpp"
#include "mpm/setup/method.hpp"

namespace assay::mpm {

template <int Dim>
struct KernelState {
  Method method;
  std::size_t particles = 0;
  std::array<ColumnData, column_count> columns{};
  GridField<Dim + 1> inertia{};              ///< mass, momentum
  GridField<Dim> force{};                    ///< internal and body force [N]
  GridField<2 * Dim> motion{};               ///< velocity, acceleration
  std::shared_ptr<void> basis{};             ///< the weights of all particles; its type is known to the kernels
  std::vector<NodeBox<Dim>> reach{};         ///< of the particles of each block
  std::vector<unsigned char> on_lines{};     ///< whether a particle of each block is; empty where it does not matter
  Column stress_of_forces = Column::stress;  ///< what internal forces are made of
  std::vector<double> block_power{};         ///< of the body force, by block; empty where accounts are not kept [W]

  double* column(Column which, std::integral auto component) {
    return columns[static_cast<std::size_t>(which)].component(static_cast<std::size_t>(component));
  }
  const double* column(Column which, std::integral auto component) const {
    return columns[static_cast<std::size_t>(which)].component(static_cast<std::size_t>(component));
  }
  double* column(Column which) { return column(which, 0); }
  const double* column(Column which) const { return column(which, 0); }
  /// The first N components at one particle.
  template <std::size_t N>
  std::array<double, N> at(Column which, std::size_t p) const {
    std::array<double, N> values;
    for (std::size_t c = 0; c < N; ++c) values[c] = column(which, c)[p];
    return values;
  }
  bool has(Column which) const { return !columns[static_cast<std::size_t>(which)].empty(); }
};

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

/// Index of component (i, d) of the stress column.
template <int Dim>
constexpr std::size_t stress_index(std::size_t i, std::size_t d) {
  constexpr std::size_t in_space[] = {0, 3, 4, 3, 1, 5, 4, 5, 2};
  return Dim == 2 ? i * Dim + d : in_space[i * Dim + d];
}

}  // namespace assay::mpm
