// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/kernels/mass_stencil.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

#include "mpm/data/crew.hpp"

namespace assay::mpm {

namespace {

constexpr std::size_t nodes_at_once = 256;
/// Rows that differ by less are the same but for rounding: of the particles' places, of which it is of a cell's size
/// what it is of one times the cells on the way there [of the diagonal, a cell].
constexpr double same_rows = 16 * std::numeric_limits<double>::epsilon();

/// Steps along the axes from a node to its neighbour k of (2 nodes_across - 1)^Dim.
template <int Dim>
std::array<int, Dim> steps_to(int k, int nodes_across) {
  const int span = 2 * nodes_across - 1;
  std::array<int, Dim> steps{};
  for (int& step : steps) {
    step = k % span - (nodes_across - 1);
    k /= span;
  }
  return steps;
}

}  // namespace

template <int Dim>
std::size_t MassStencil<Dim>::entries(int nodes_across) {
  std::size_t product = 1;
  for (int d = 0; d < Dim; ++d) product *= static_cast<std::size_t>(2 * nodes_across - 1);
  return product;
}

template <int Dim>
MassStencil<Dim>::MassStencil(const GridGeometry<Dim>& grid, int nodes_across, const Multiply& multiply,
                              const AddRows& add_rows, Instructions instructions)
    : nodes_(grid.nodes()), nodes_across_(nodes_across), multiply_rows_(multiply_rows_of<Dim>(instructions)) {
  for (std::size_t d = 0; d < Dim; ++d) {
    farthest_ = std::max({farthest_, std::abs(grid.first[d]), std::abs(grid.first[d] + grid.count[d])});
  }
  find_neighbours(grid);
  own_.assign(nodes_, 0);
  kinds_.assign(nodes_, Kind::none);
  if constexpr (Dim == 2) {
    find_values(grid, multiply);
    find_alike();
  } else {
    find_rows(grid, multiply, add_rows);
  }
  find_pieces();
}

/// Groups of the table for the nodes that are to have rows, in the order of the grid.
template <int Dim>
void MassStencil<Dim>::make_room() {
  std::uint32_t groups = 0;
  group_.assign((nodes_ + rows_at_once<Dim> - 1) / rows_at_once<Dim>, MassRows<Dim>::no_rows);
  for (std::size_t i = 0; i < nodes_; ++i) {
    if (own_[i] && group_[i / rows_at_once<Dim>] == MassRows<Dim>::no_rows) group_[i / rows_at_once<Dim>] = groups++;
  }
  values_.assign(groups * offsets_.size() * rows_at_once<Dim>, 0.0);
}

template <int Dim>
void MassStencil<Dim>::find_neighbours(const GridGeometry<Dim>& grid) {
  offsets_.resize(entries(nodes_across_));
  for (std::size_t k = 0; k < offsets_.size(); ++k) {
    const std::array<int, Dim> steps = steps_to<Dim>(static_cast<int>(k), nodes_across_);
    std::ptrdiff_t stride = 1;
    for (std::size_t d = 0; d < Dim; ++d) {
      offsets_[k] += steps[d] * stride;
      stride *= grid.count[d];
    }
  }
}

/// Column after column: x is 1 at nodes so far from each other that no two have a neighbour in common.
template <int Dim>
void MassStencil<Dim>::find_values(const GridGeometry<Dim>& grid, const Multiply& multiply) {
  const int span = 2 * nodes_across_ - 1;
  own_.assign(nodes_, 1);
  make_room();
  GridField<Dim> x, y;
  x.allocate(nodes_);
  y.allocate(nodes_);
  for (int colour = 0; colour < static_cast<int>(offsets_.size()); ++colour) {
    const std::array<int, Dim> rest = steps_to<Dim>(colour, nodes_across_);
    const auto column_of = [&](std::size_t i, std::array<int, Dim>& steps) {  // the neighbour of i that has this colour
      for (std::size_t d = 0; d < Dim; ++d) {
        const int at = static_cast<int>(i % static_cast<std::size_t>(grid.count[d]));
        i /= static_cast<std::size_t>(grid.count[d]);
        const int distance = ((rest[d] + nodes_across_ - 1 - at) % span + span) % span;
        steps[d] = distance < nodes_across_ ? distance : distance - span;
        if (at + steps[d] < 0 || at + steps[d] >= grid.count[d]) return false;
      }
      return true;
    };
    std::array<int, Dim> steps;
    for (std::size_t i = 0; i < nodes_; ++i) {
      x.node(i)[0] =
          column_of(i, steps) && std::all_of(steps.begin(), steps.end(), [](int s) { return s == 0; }) ? 1 : 0;
    }
    multiply(x, y);
    for (std::size_t i = 0; i < nodes_; ++i) {
      if (y.node(i)[0] == 0 || !column_of(i, steps)) continue;
      int k = 0;
      for (std::size_t d = Dim; d-- > 0;) k = k * span + steps[d] + nodes_across_ - 1;
      rows().row(i)[static_cast<std::size_t>(k) * rows_at_once<Dim>] = y.node(i)[0];
    }
  }
}

/// The row of the node whose diagonal is the median: on a fine grid, of one inside the body.
template <int Dim>
void MassStencil<Dim>::find_alike() {
  std::vector<std::size_t> with_mass;
  for (std::size_t i = 0; i < nodes_; ++i) {
    if (value_of_own(middle(), i) != 0) with_mass.push_back(i);
  }
  alike_.assign(offsets_.size(), 0.0);
  if (with_mass.empty()) return;
  const auto median = with_mass.begin() + static_cast<std::ptrdiff_t>(with_mass.size() / 2);
  std::nth_element(with_mass.begin(), median, with_mass.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(value_of_own(middle(), a), a) < std::pair(value_of_own(middle(), b), b);
  });
  for (std::size_t k = 0; k < alike_.size(); ++k) alike_[k] = value_of_own(k, *median);
  for (std::size_t i = 0; i < nodes_; ++i) kinds_[i] = kind_of(i);
}

template <int Dim>
typename MassStencil<Dim>::Kind MassStencil<Dim>::kind_of(std::size_t i) const {
  if (value_of_own(middle(), i) == 0) return Kind::none;
  const auto reach = static_cast<std::size_t>(offsets_.back());  // the farthest
  if (i < reach + rows_at_once<Dim> || nodes_ < i + reach + rows_at_once<Dim>) return Kind::at_end;
  const double rounding = same_rows * farthest_ * alike_[middle()];
  for (std::size_t k = 0; k < offsets_.size(); ++k) {
    if (!(std::abs(value_of_own(k, i) - alike_[k]) <= rounding)) return Kind::own;
  }
  return Kind::alike;
}

/// No longer than threads can share well.
template <int Dim>
void MassStencil<Dim>::find_pieces() {
  for (std::size_t i = 0; i < nodes_; ++i) {
    const Kind kind = kinds_[i];
    if (kind == Kind::none) continue;
    const bool goes_on = !pieces_.empty() && pieces_.back().end == i && pieces_.back().kind == kind &&
                         i - pieces_.back().begin < nodes_at_once;
    if (!goes_on) pieces_.push_back({i, i, kind});
    ++pieces_.back().end;
  }
}

template <int Dim>
std::array<std::vector<double>, Dim> MassStencil<Dim>::means() const {
  std::array<std::vector<double>, Dim> means;
  for (auto& mean : means) mean.assign(static_cast<std::size_t>(nodes_across_), 0.0);
  double all = 0;
  for (std::size_t k = 0; k < offsets_.size(); ++k) {
    double sum = 0;
    for (std::size_t i = 0; i < nodes_; ++i) sum += value(k, i);
    const std::array<int, Dim> steps = steps_to<Dim>(static_cast<int>(k), nodes_across_);
    all += sum;
    for (std::size_t d = 0; d < Dim; ++d) {
      means[d][static_cast<std::size_t>(std::abs(steps[d]))] += steps[d] == 0 ? sum : 0.5 * sum;
    }
  }
  for (auto& mean : means) {
    for (double& share : mean) share /= all;
  }
  return means;
}

template <int Dim>
void MassStencil<Dim>::multiply_at_end(const Piece& piece, const GridField<Dim>& x, GridField<Dim>& y) const {
  for (std::size_t i = piece.begin; i < piece.end; ++i) {
    std::fill_n(y.node(i), Dim, 0.0);
    for (std::size_t k = 0; k < offsets_.size(); ++k) {
      const auto j = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i) + offsets_[k]);  // wraps below zero
      for (std::size_t d = 0; j < nodes_ && d < Dim; ++d) y.node(i)[d] += value(k, i) * x.node(j)[d];
    }
  }
}

template <int Dim>
void MassStencil<Dim>::multiply_piece(const Piece& piece, const GridField<Dim>& x, GridField<Dim>& y) const {
  if (piece.kind == Kind::at_end) return multiply_at_end(piece, x, y);
  const bool alike = piece.kind == Kind::alike;
  const double* values = alike_.data();
  if (!alike)
    values =
        values_.data() + std::size_t{group_[piece.begin / rows_at_once<Dim>]} * offsets_.size() * rows_at_once<Dim>;
  multiply_rows_({piece.begin, piece.end, offsets_, values, alike, x.data(), y.data()});
}

template <int Dim>
void MassStencil<Dim>::for_nodes(int threads, const OnNodes& body) const {
  share_out(threads, pieces_.size(), [&](std::size_t p) { body(pieces_[p].begin, pieces_[p].end); });
}

template <int Dim>
void MassStencil<Dim>::multiply(const GridField<Dim>& x, GridField<Dim>& y, int threads, const OnNodes& after) const {
  share_out(threads, pieces_.size(), [&](std::size_t p) {
    multiply_piece(pieces_[p], x, y);
    after(pieces_[p].begin, pieces_[p].end);
  });
}

template <int Dim>
void MassStencil<Dim>::multiply(const GridField<Dim>& x, GridField<Dim>& y, int threads) const {
  y.zero();
  multiply(x, y, threads, [](std::size_t, std::size_t) {});
}

template class MassStencil<ASSAY_DIMENSION>;

}  // namespace assay::mpm
