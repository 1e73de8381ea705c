// SPDX-License-Identifier: BSD-3-Clause
// An approximate inverse of the mass matrix that knows the body's inside exactly.
#pragma once

#include <array>
#include <vector>

#include "mpm/grid/grid_field.hpp"
#include "mpm/grid/grid_geometry.hpp"

namespace assay::mpm {

/// Of the tensor product of one banded Toeplitz matrix an axis: what a mass matrix, divided by its row sums, is where
/// all cells hold the same particles. Its numbers are means of the matrix over the body, so that it is positive
/// definite where that is: x^H M x of a wave x is the mean's symbol.
template <int Dim>
class MassPreconditioner {
 public:
  /// means[d][k]: share of a row's sum that lies k steps away along axis d, on one side.
  MassPreconditioner(const GridGeometry<Dim>& grid, const std::array<std::vector<double>, Dim>& means);

  /// x = T^-1 x.
  void solve(GridField<Dim>& x) const;

 private:
  /// L D L^T of a line of nodes.
  struct Factor {
    std::size_t nodes = 0, reach = 0;
    std::vector<double> lower;             ///< L of node i and its k-th neighbour below, [i * reach + k - 1]
    std::vector<double> inverse_diagonal;  ///< of D
  };
  static Factor factor_of(std::size_t nodes, const std::vector<double>& mean);
  template <class Width>
  static void solve_lines(const Factor& factor, double* x, Width inner, std::size_t lines);

  std::array<Factor, Dim> factors_;
};

}  // namespace assay::mpm
