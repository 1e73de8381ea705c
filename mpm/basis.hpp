// SPDX-License-Identifier: BSD-3-Clause
// What every basis offers to the passes, and what the bases share.
//
// A basis keeps the weights of all particles for one step and offers three operations:
//   place(p, x, F)            computes the weights of a particle; false where it reaches outside the grid
//   place(p, x, F, half)      the same for a reference domain of its own, given by domain_components numbers: the half
//                             edges along the axes, or Dim x Dim row-major whose column d is half edge d [m]
//   scatter<K, G>(p, A, B, f) adds w_i A + (0, B grad w_i) to each node i: A has K components, B acts on the last G
//   gather<K, G>(p, f, v, g)  v = sum_i w_i f_i (K components), g = sum_i f_i (x) grad w_i of the first G of them
//   each_node(p, visit)       visit(i, w_i, r_i) with r_i = x_i - sum_j w_j x_j, where nodes may come in parts
// where w_i is phi_ip, the weight of node i for particle p, and grad w_i its gradient [1/m].
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mpm/grid_field.hpp"
#include "mpm/setup.hpp"

namespace assay::mpm {

template <int Dim>
using Vec = std::array<double, Dim>;
template <int Dim>
using Mat = std::array<double, Dim * Dim>;  ///< row-major

template <int Dim>
double determinant(const Mat<Dim>& F) {
  if constexpr (Dim == 2) {
    return F[0] * F[3] - F[1] * F[2];
  } else {
    return F[0] * (F[4] * F[8] - F[5] * F[7]) - F[1] * (F[3] * F[8] - F[5] * F[6]) + F[2] * (F[3] * F[7] - F[4] * F[6]);
  }
}

/// F^-T, row-major, from F and its determinant.
template <int Dim>
Mat<Dim> inverse_transpose(const Mat<Dim>& F, double det) {
  const double s = 1 / det;
  if constexpr (Dim == 2) {
    return {s * F[3], -s * F[2], -s * F[1], s * F[0]};
  } else {
    return {s * (F[4] * F[8] - F[5] * F[7]), s * (F[5] * F[6] - F[3] * F[8]), s * (F[3] * F[7] - F[4] * F[6]),
            s * (F[2] * F[7] - F[1] * F[8]), s * (F[0] * F[8] - F[2] * F[6]), s * (F[1] * F[6] - F[0] * F[7]),
            s * (F[1] * F[5] - F[2] * F[4]), s * (F[2] * F[3] - F[0] * F[5]), s * (F[0] * F[4] - F[1] * F[3])};
  }
}

/// Turns a position into cell coordinates of the local grid.
template <int Dim>
struct Locator {
  double inverse_spacing = 0;
  Vec<Dim> first{};      ///< global index of the first node
  Vec<Dim> last_cell{};  ///< cell coordinates must be below this
  std::array<std::int32_t, Dim> stride{};

  Locator() = default;
  explicit Locator(const GridGeometry<Dim>& grid) : inverse_spacing(1 / grid.spacing) {
    std::int32_t product = 1;
    for (std::size_t d = 0; d < Dim; ++d) {
      first[d] = grid.first[d];
      last_cell[d] = grid.count[d] - 1;
      stride[d] = product;
      product *= grid.count[d];
    }
  }

  /// Node at the lower corner of the cell and the fraction inside it; false outside the grid or where x is no number.
  bool cell_of(const Vec<Dim>& x, std::int32_t& node, Vec<Dim>& fraction) const {
    node = 0;
    bool inside = true;
    for (std::size_t d = 0; d < Dim; ++d) {
      const double along = x[d] * inverse_spacing - first[d];
      inside = inside && along >= 0 && along < last_cell[d];
      const auto cell = inside ? static_cast<std::int32_t>(along) : 0;
      fraction[d] = along - cell;
      node += cell * stride[d];
    }
    return inside;
  }
};

/// Cell coordinates of a node [h], from the local grid's first node.
template <int Dim>
Vec<Dim> coordinates_of(const Locator<Dim>& locator, std::int32_t node) {
  Vec<Dim> along{};
  for (std::size_t d = Dim; d-- > 0;) {
    const std::int32_t at = node / locator.stride[d];
    node -= at * locator.stride[d];
    along[d] = at;
  }
  return along;
}

/// The 2^Dim weights of a cell's corners at a fraction, first direction fastest.
template <int Dim>
std::array<double, 1 << Dim> multilinear(const Vec<Dim>& f) {
  if constexpr (Dim == 2) {
    const double gx = 1 - f[0], gy = 1 - f[1];
    return {gx * gy, f[0] * gy, gx * f[1], f[0] * f[1]};
  } else {
    const double gx = 1 - f[0], gy = 1 - f[1], gz = 1 - f[2];
    return {gx * gy * gz,   f[0] * gy * gz,   gx * f[1] * gz,   f[0] * f[1] * gz,
            gx * gy * f[2], f[0] * gy * f[2], gx * f[1] * f[2], f[0] * f[1] * f[2]};
  }
}

/// Offset of corner c of a cell from its lower node.
template <int Dim>
std::array<std::int32_t, 1 << Dim> corner_offsets(const Locator<Dim>& locator) {
  std::array<std::int32_t, 1 << Dim> offsets{};
  for (int c = 0; c < 1 << Dim; ++c) {
    for (int d = 0; d < Dim; ++d) {
      if (c >> d & 1) offsets[static_cast<std::size_t>(c)] += locator.stride[static_cast<std::size_t>(d)];
    }
  }
  return offsets;
}

}  // namespace assay::mpm
