// SPDX-License-Identifier: BSD-3-Clause
// What every basis offers to the kernels, and what the bases share.
//
// A basis keeps what the weights of all particles follow from, `bytes` of each, for one step:
//   place(p, x, F)               finds the nodes of a particle; false where it reaches outside the grid
//   place(p, x, F, half)         the same for a reference domain of its own, given by domain_components numbers: the
//                                half edges along the axes, or Dim x Dim row-major whose column d is half edge d [m]
//   reach(begin, end, nodes)     the box of nodes in which those of particles lie
// and makes them again, for a few neighbouring particles at once:
//   expand(begin, n, nodes)           weights and slopes
//   slopes_to_moments(n, nodes)       w_i r_i in place of grad w_i, for add_affine and moment
//   add_all<K, WithSlopes>(nodes, n, given, f)   adds w_i A + sum_d B_d grad_d w_i to each node i; add for one of them
//   add_all_affine<K>(nodes, n, given, f)        adds w_i (A + sum_d B_d r_i,d); add_affine for one of them
//   sum_all<K, G>(nodes, n, f, taken)            sum_i w_i f_i (K components), sum_i f_i (x) grad w_i of the first G;
//                                                sum for one of them
//   moment<K>(nodes, k, f)            sum_i w_i f_i (x) r_i of the first Dim components
//   spread(nodes, k)                  D = sum_i w_i r_i (x) r_i [m^2]
// where w_i is phi_ip, the weight of node i for particle p, grad w_i its gradient [1/m] and r_i = x_i - sum_j w_j x_j.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mpm/basis/traits.hpp"
#include "mpm/grid/grid_field.hpp"
#include "mpm/grid/grid_geometry.hpp"

namespace assay::mpm {

template <int Dim>
using Vec = std::array<double, Dim>;
template <int Dim>
using Mat = std::array<double, Dim * Dim>;  ///< row-major

template <int Dim>
ASSAY_INLINE double determinant(const Mat<Dim>& F) {
  if constexpr (Dim == 2) {
    return F[0] * F[3] - F[1] * F[2];
  } else {
    return F[0] * (F[4] * F[8] - F[5] * F[7]) - F[1] * (F[3] * F[8] - F[5] * F[6]) + F[2] * (F[3] * F[7] - F[4] * F[6]);
  }
}

/// F^-T, row-major, from F and its determinant.
template <int Dim>
ASSAY_INLINE Mat<Dim> inverse_transpose(const Mat<Dim>& F, double det) {
  const double s = 1 / det;
  if constexpr (Dim == 2) {
    return {s * F[3], -s * F[2], -s * F[1], s * F[0]};
  } else {
    return {s * (F[4] * F[8] - F[5] * F[7]), s * (F[5] * F[6] - F[3] * F[8]), s * (F[3] * F[7] - F[4] * F[6]),
            s * (F[2] * F[7] - F[1] * F[8]), s * (F[0] * F[8] - F[2] * F[6]), s * (F[1] * F[6] - F[0] * F[7]),
            s * (F[1] * F[5] - F[2] * F[4]), s * (F[2] * F[3] - F[0] * F[5]), s * (F[0] * F[4] - F[1] * F[3])};
  }
}

/// Cells between a particle and a line that are none but rounding, in a grid of up to 1e4 cells.
inline constexpr double on_line = 1e-11;

/// The least and the largest of many numbers from 0 on, Lanes at once.
template <std::size_t Lanes>
struct Extremes {
  double low[Lanes], high[Lanes];

  ASSAY_INLINE explicit Extremes(double most) {
    for (std::size_t l = 0; l < Lanes; ++l) low[l] = most, high[l] = 0;
  }
  ASSAY_INLINE void include(std::size_t l, double x) {
    low[l] = x < low[l] ? x : low[l];
    high[l] = x > high[l] ? x : high[l];
  }
  ASSAY_INLINE double lowest() const {
    double found = low[0];
    for (std::size_t l = 1; l < Lanes; ++l) found = low[l] < found ? low[l] : found;
    return found;
  }
  ASSAY_INLINE double highest() const {
    double found = high[0];
    for (std::size_t l = 1; l < Lanes; ++l) found = high[l] > found ? high[l] : found;
    return found;
  }
};

/// Turns a position into cell coordinates of the local grid.
template <int Dim>
struct Locator {
  double spacing = 0, inverse_spacing = 0;
  Vec<Dim> first{};      ///< global index of the first node, and its offset
  Vec<Dim> last_cell{};  ///< cell coordinates must be below this
  std::array<std::int32_t, Dim> stride{};

  Locator() = default;
  explicit Locator(const GridGeometry<Dim>& grid) : spacing(grid.spacing), inverse_spacing(1 / grid.spacing) {
    std::int32_t product = 1;
    for (std::size_t d = 0; d < Dim; ++d) {
      first[d] = grid.first[d] + grid.offset[d];
      last_cell[d] = grid.count[d] - 1;
      stride[d] = product;
      product *= grid.count[d];
    }
  }

  /// Cell coordinates of x; zero and false outside the grid or where x is no number. WithEnd counts its edge as inside.
  template <bool WithEnd = false>
  ASSAY_INLINE bool inside(const Vec<Dim>& x, Vec<Dim>& along) const {
    bool good = true;
    for (std::size_t d = 0; d < Dim; ++d) {
      along[d] = x[d] * inverse_spacing - first[d];
      good = good && along[d] >= 0 && (WithEnd ? along[d] <= last_cell[d] : along[d] < last_cell[d]);
    }
    if (!good) along = {};
    return good;
  }
};

/// What all bases share. A basis that differs declares the member again.
template <class Derived, int Dim>
class BasisOf {
 public:
  static constexpr BasisTraits traits{};
  static constexpr bool may_cross_edges = false;       ///< weights may reach over the grid's edge (SeparableBasis)
  static constexpr std::size_t domain_components = 0;  ///< numbers that a reference domain of its own takes

  /// Adds w_i A + (0, B grad w_i) to each node i: A has K components, B acts on the last G.
  template <int K, int G>
  void scatter(std::size_t p, const std::array<double, K>& A, const std::array<double, G * Dim>& B,
               double* field) const {
    typename Derived::Nodes nodes;
    derived().expand(p, 1, nodes);
    NodePacks<K, Dim> value;
    value.template set<G>(A, B);
    derived().template add<K, (G > 0)>(nodes, 0, value, field);
  }

  /// v = sum_i w_i f_i (K components), g = sum_i f_i (x) grad w_i of the first G of them.
  template <int K, int G>
  void gather(std::size_t p, const double* field, std::array<double, K>& value,
              std::array<double, G * Dim>& gradient) const {
    typename Derived::Nodes nodes;
    derived().expand(p, 1, nodes);
    NodePacks<K, Dim> found;
    derived().template sum<K, (G > 0)>(nodes, 0, field, found);
    found.template get<G>(value, gradient);
  }

 private:
  const Derived& derived() const { return static_cast<const Derived&>(*this); }
};

}  // namespace assay::mpm
