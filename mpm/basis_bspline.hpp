// SPDX-License-Identifier: BSD-3-Clause
// Quadratic and cubic B-splines centred at the nodes. Steffen, Kirby, Berzins (2008).
//
// A particle near the edge of the grid would need a node beyond it. What that one weighs goes to the last two nodes as
// a linear field is continued, f_-1 = 2 f_0 - f_1: the functions still sum to one and reproduce linear fields, and the
// one at the edge is 1 there, the others 0.
#pragma once

#include "mpm/basis_separable.hpp"

namespace assay::mpm {

template <int Dim, int Degree>
class BsplineBasis : public SeparableBasis<BsplineBasis<Dim, Degree>, Dim, Degree + 1> {
  static_assert(Degree == 2 || Degree == 3);

 public:
  static constexpr const char* name = Degree == 2 ? "bspline2" : "bspline3";
  static constexpr bool uses_deformation = false;
  static constexpr std::size_t domain_components = 0;
  static constexpr bool may_cross_edges = true;
  static constexpr std::size_t bytes = Dim * sizeof(double);  ///< of the weights a particle

  BsplineBasis(const GridGeometry<Dim>& grid, const Vec<Dim>&, std::size_t particles)
      : SeparableBasis<BsplineBasis, Dim, width>(grid), along_(particles) {}

  ASSAY_INLINE bool place(std::size_t p, const Vec<Dim>& x, const Mat<Dim>&) {
    Vec<Dim>& along = along_[p];
    bool inside = true;
    for (std::size_t d = 0; d < Dim; ++d) {
      along[d] = x[d] * this->locator_.inverse_spacing - this->locator_.first[d];
      inside = inside && along[d] >= 0 && along[d] <= this->locator_.last_cell[d];
    }
    if (!inside) along = {};
    return inside;
  }

  ASSAY_INLINE double along(std::size_t p, std::size_t d) const { return along_[p][d]; }

  ASSAY_INLINE void line(std::size_t p, std::size_t d, double* value, double* slope, std::int32_t& first) const {
    const double along = along_[p][d], s = this->locator_.inverse_spacing;
    // Degree 2: around the nearest node; 3: around the cell.
    const auto middle = static_cast<std::int32_t>(Degree == 2 ? along + 0.5 : along);
    const double f = along - middle;
    first = middle - 1;
    if constexpr (Degree == 2) {
      const double below = 0.5 - f, above = 0.5 + f;
      value[0] = 0.5 * below * below;
      value[1] = 0.75 - f * f;
      value[2] = 0.5 * above * above;
      slope[0] = -s * below;
      slope[1] = -2 * s * f;
      slope[2] = s * above;
    } else {
      constexpr double sixth = 1.0 / 6;
      const double g = 1 - f;
      value[0] = sixth * g * g * g;
      value[1] = sixth * (4 + f * f * (3 * f - 6));
      value[2] = sixth * (4 + g * g * (3 * g - 6));
      value[3] = sixth * f * f * f;
      slope[0] = -0.5 * s * g * g;
      slope[1] = s * f * (1.5 * f - 2);
      slope[2] = -s * g * (1.5 * g - 2);
      slope[3] = 0.5 * s * f * f;
    }
  }

  ASSAY_INLINE void fold(std::size_t d, std::int32_t& first, double* value, double* slope) const {
    if (first < 0) {
      fold_lower(value);
      fold_lower(slope);
      first = 0;
    }
    for (; first + width > this->count_[d]; --first) {
      fold_upper(this->count_[d] - first, value);
      fold_upper(this->count_[d] - first, slope);
    }
  }

 private:
  static constexpr int width = Degree + 1;

  /// The first weight is of node -1.
  ASSAY_INLINE static void fold_lower(double* w) {
    w[1] += 2 * w[0];
    w[2] -= w[0];
    for (int k = 0; k + 1 < width; ++k) w[k] = w[k + 1];
    w[width - 1] = 0;
  }

  /// Weight `beyond` and any after it are of nodes beyond the last. Two of them only where a cubic stands on the edge
  /// itself, and the second is zero there.
  ASSAY_INLINE static void fold_upper(std::int32_t beyond, double* w) {
    if (beyond < width) {
      w[beyond - 1] += 2 * w[beyond];
      w[beyond - 2] -= w[beyond];
      for (int k = beyond; k > 0; --k) w[k] = w[k - 1];
      w[0] = 0;
    }
  }

  std::vector<Vec<Dim>> along_;  ///< cell coordinates
};

template <int Dim>
using Bspline2Basis = BsplineBasis<Dim, 2>;
template <int Dim>
using Bspline3Basis = BsplineBasis<Dim, 3>;

}  // namespace assay::mpm
