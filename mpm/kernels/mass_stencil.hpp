// SPDX-License-Identifier: BSD-3-Clause
// The mass matrix of particles whose weights never change, as numbers between nodes: made once, and many times faster
// to apply than by way of the particles.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "mpm/data/instructions.hpp"
#include "mpm/grid/grid_field.hpp"
#include "mpm/grid/grid_geometry.hpp"
#include "mpm/kernels/mass_rows.hpp"

namespace assay::mpm {

/// Rows of neighbouring nodes, and what they are multiplied by. What lies around them in groups of `rows_at_once` is
/// read, too, but not written.
template <int Dim>
struct StencilRows {
  static constexpr std::size_t at_once = rows_at_once<Dim>;
  std::size_t begin = 0, end = 0;           ///< nodes
  std::span<const std::ptrdiff_t> offsets;  ///< nodes from a row's own to the one that entry k is for
  const double* values = nullptr;           ///< those of the first group; or one row of all, where they are alike
  bool alike = false;
  const double* from = nullptr;  ///< Dim numbers a node, in packs
  double* to = nullptr;

  static std::size_t value_at(std::size_t i, std::size_t k, std::size_t entries) {
    return (i / at_once * entries + k) * at_once + i % at_once;
  }
  /// Entry k of node i is at [k * rows_at_once].
  const double* row(std::size_t i) const { return values + value_at(i - begin / at_once * at_once, 0, offsets.size()); }
};
template <int Dim>
using MultiplyRows = void (*)(const StencilRows<Dim>&);

template <int Dim>
MultiplyRows<Dim> multiply_rows_of(Instructions instructions);
template <>
MultiplyRows<2> multiply_rows_of<2>(Instructions instructions);
template <>
MultiplyRows<3> multiply_rows_of<3>(Instructions instructions);

template <int Dim>
class MassStencil {
 public:
  /// y = M x, one component after the other alike.
  using Multiply = std::function<void(const GridField<Dim>& x, GridField<Dim>& y)>;

  /// Adds the particles' parts to rows.
  using AddRows = std::function<void(const MassRows<Dim>& rows)>;

  /// The matrix that `multiply` applies, where a particle reaches over so many nodes in each direction. In space
  /// `add_rows` makes those of its rows that differ from one inside the body; in the plane all are found by `multiply`.
  MassStencil(const GridGeometry<Dim>& grid, int nodes_across, const Multiply& multiply, const AddRows& add_rows,
              Instructions instructions = best_instructions());

  /// For nodes begin to end - 1, which no other call is given; several at once where there are threads.
  using OnNodes = std::function<void(std::size_t begin, std::size_t end)>;

  /// For all nodes that have mass.
  void for_nodes(int threads, const OnNodes& body) const;

  /// y = M x; of nodes that have no mass 0.
  void multiply(const GridField<Dim>& x, GridField<Dim>& y, int threads) const;

  /// y = M x of the nodes that have mass, and after(begin, end) as soon as it is known there.
  void multiply(const GridField<Dim>& x, GridField<Dim>& y, int threads, const OnNodes& after) const;

  /// Share of all rows' sums that lies k steps away along each axis, on one side: [axis][k].
  std::array<std::vector<double>, Dim> means() const;

  /// Numbers a node of such a matrix.
  static std::size_t entries(int nodes_across);

  /// Of the table of rows.
  std::size_t bytes() const { return values_.size() * sizeof(double); }

 private:
  /// Of the nodes that have mass: with rows that are all `alike_`; with rows of their own; so near the ends of the
  /// grid's nodes that neighbours lie beyond, where rows are zero.
  enum class Kind { none, alike, own, at_end };
  struct Piece {
    std::size_t begin = 0, end = 0;
    Kind kind = Kind::none;
  };
  std::size_t middle() const { return offsets_.size() / 2; }
  MassRows<Dim> rows() { return {group_.data(), own_.data(), values_.data(), offsets_.size()}; }
  double value_of_own(std::size_t k, std::size_t i) const {
    constexpr std::size_t n = rows_at_once<Dim>;
    return values_[std::size_t{group_[i / n]} * offsets_.size() * n + i % n + k * n];
  }
  double value(std::size_t k, std::size_t i) const {  ///< of any node
    if (Dim == 2) return value_of_own(k, i);
    return kinds_[i] == Kind::none ? 0 : kinds_[i] == Kind::alike ? alike_[k] : value_of_own(k, i);
  }
  void find_neighbours(const GridGeometry<Dim>& grid);
  void make_room();
  void find_rows(const GridGeometry<Dim>& grid, const Multiply& multiply, const AddRows& add_rows);
  std::vector<bool> nodes_inside(const GridGeometry<Dim>& grid, const Multiply& multiply, std::size_t& middle_node,
                                 std::vector<bool>& has_mass) const;
  void find_values(const GridGeometry<Dim>& grid, const Multiply& multiply);
  void find_alike();
  Kind kind_of(std::size_t i) const;
  void find_pieces();
  void multiply_piece(const Piece& piece, const GridField<Dim>& x, GridField<Dim>& y) const;
  void multiply_at_end(const Piece& piece, const GridField<Dim>& x, GridField<Dim>& y) const;

  std::size_t nodes_;
  int nodes_across_;
  int farthest_ = 1;                     ///< node from where x = 0 [h]
  std::vector<std::ptrdiff_t> offsets_;  ///< of the neighbours of a node
  std::vector<double> values_;           ///< M between nodes that have rows of their own and these [kg]
  std::vector<std::uint32_t> group_;     ///< of the table, for each `rows_at_once` nodes; MassRows<Dim>::no_rows: none
  std::vector<unsigned char> own_;       ///< of each node, whether it has a row there
  std::vector<Kind> kinds_;              ///< of each node
  std::vector<double> alike_;            ///< the row of a node like many others [kg]
  std::vector<Piece> pieces_;
  MultiplyRows<Dim> multiply_rows_;
};

}  // namespace assay::mpm
