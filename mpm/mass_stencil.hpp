// SPDX-License-Identifier: BSD-3-Clause
// The mass matrix of particles whose weights never change, as numbers between nodes: made once, and many times faster
// to apply than by way of the particles.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "mpm/grid_field.hpp"
#include "mpm/grid_geometry.hpp"
#include "mpm/instructions.hpp"

namespace assay::mpm {

/// to += m from, for neighbouring nodes.
struct StencilLine {
  const double* m = nullptr;     ///< a number a node
  const double* from = nullptr;  ///< Dim numbers a node, in packs
  double* to = nullptr;
  std::size_t nodes = 0;
};
using AddProducts = void (*)(const StencilLine&);

template <int Dim>
AddProducts add_products_of(Instructions instructions);
template <>
AddProducts add_products_of<2>(Instructions instructions);
template <>
AddProducts add_products_of<3>(Instructions instructions);

template <int Dim>
class MassStencil {
 public:
  /// y = M x, one component after the other alike.
  using Multiply = std::function<void(const GridField<Dim>& x, GridField<Dim>& y)>;

  /// The matrix that `multiply` applies, where a particle reaches over so many nodes in each direction.
  MassStencil(const GridGeometry<Dim>& grid, int nodes_across, const Multiply& multiply,
              Instructions instructions = best_instructions());

  /// y = M x.
  void multiply(const GridField<Dim>& x, GridField<Dim>& y, int threads) const;

  /// Share of all rows' sums that lies k steps away along each axis, on one side: [axis][k].
  std::array<std::vector<double>, Dim> means() const;

  /// Numbers a node of such a matrix.
  static std::size_t entries(int nodes_across);

 private:
  struct Neighbour {
    std::array<int, Dim> steps{};
    std::ptrdiff_t offset = 0;   ///< of its node
    std::vector<double> values;  ///< M between each node and this neighbour of it [kg]
  };
  struct Piece {
    std::size_t begin = 0, end = 0;
  };
  void find_pieces();

  std::size_t nodes_;
  int nodes_across_;
  std::vector<Neighbour> neighbours_;
  std::vector<Piece> pieces_;  ///< of nodes that have mass
  AddProducts add_products_;
};

}  // namespace assay::mpm
