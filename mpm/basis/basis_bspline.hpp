// SPDX-License-Identifier: BSD-3-Clause
// B-splines of degree 2, 3 and 4 centred at the nodes. Steffen, Kirby, Berzins (2008).
//
// A particle near the edge of the grid would need nodes beyond it. What these weigh goes to the edge and to their
// mirror images, as an odd field is continued, f_-j = 2 f_0 - f_j: the functions still sum to one and reproduce linear
// fields, and the one at the edge is 1 there, the others 0.
#pragma once

#include "mpm/basis/basis_separable.hpp"

namespace assay::mpm {

template <int Dim, int Degree>
class BsplineBasis : public SeparableBasis<BsplineBasis<Dim, Degree>, Dim, Degree + 1> {
  static_assert(Degree >= 2 && Degree <= 4);

 public:
  static constexpr bool may_cross_edges = true;
  static constexpr BasisTraits traits{
      .name = Degree == 2   ? "quadratic B-spline"
              : Degree == 3 ? "cubic B-spline"
                            : "quartic B-spline",
      .why_not_deformed =
          "B-splines are evaluated at the particles, which are no accurate quadrature points if their "
          "volumes differ",
      .why_not_surface = Degree == 2
                             ? ""
                             : "two points a cell do not integrate cubic and quartic B-splines exactly, and this shows "
                               "at a face, which cuts the splines off"};

  BsplineBasis(const GridGeometry<Dim>& grid, const Vec<Dim>&, std::size_t particles)
      : SeparableBasis<BsplineBasis, Dim, width>(grid, particles) {}

  ASSAY_INLINE bool place(std::size_t p, const Vec<Dim>& x, const Mat<Dim>&) {
    return this->locator_.template inside<true>(x, this->places_[p].along);
  }

  ASSAY_INLINE void line(std::size_t p, std::size_t d, double* value, double* slope, std::int32_t& first) const {
    const double along = this->along(p, d), s = this->locator_.inverse_spacing;
    // Even degrees: around the nearest node; odd: around the cell.
    const auto middle = static_cast<std::int32_t>(Degree % 2 == 0 ? along + 0.5 : along);
    const double f = along - middle;
    first = middle - Degree / 2;
    if constexpr (Degree == 2) {
      quadratic(f, s, value, slope);
    } else if constexpr (Degree == 3) {
      cubic(f, s, value, slope);
    } else {
      quartic(f, s, value, slope);
    }
  }

  ASSAY_INLINE void fold(std::size_t d, std::int32_t& first, double* value, double* slope) const {
    if (first < 0) {
      fold_lower(-first, value);
      fold_lower(-first, slope);
      first = 0;
    }
    if (const std::int32_t beyond = first + width - this->count_[d]; beyond > 0) {
      fold_upper(beyond, value);
      fold_upper(beyond, slope);
      first -= beyond;
    }
  }

 private:
  static constexpr int width = Degree + 1;

  ASSAY_INLINE static void quadratic(double f, double s, double* value, double* slope) {
    const double below = 0.5 - f, above = 0.5 + f;
    value[0] = 0.5 * below * below;
    value[1] = 0.75 - f * f;
    value[2] = 0.5 * above * above;
    slope[0] = -s * below;
    slope[1] = -2 * s * f;
    slope[2] = s * above;
  }

  ASSAY_INLINE static void cubic(double f, double s, double* value, double* slope) {
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

  /// Node i and those i - 2 to i + 2 around it, f in [-1/2, 1/2] from it.
  ASSAY_INLINE static void quartic(double f, double s, double* value, double* slope) {
    constexpr double outer = 1.0 / 384, inner = 1.0 / 96;
    const double below = 1 - 2 * f, above = 1 + 2 * f, square = f * f;
    const double even = 19 + square * (24 - 16 * square), odd = f * (16 * square - 44);
    const double even_slope = 12 * square - 11, odd_slope = f * (12 - 16 * square);
    value[0] = outer * below * below * below * below;
    value[1] = inner * (even + odd);
    value[2] = 230 * outer + square * (0.25 * square - 0.625);
    value[3] = inner * (even - odd);
    value[4] = outer * above * above * above * above;
    slope[0] = -8 * outer * s * below * below * below;
    slope[1] = 4 * inner * s * (odd_slope + even_slope);
    slope[2] = s * f * (square - 1.25);
    slope[3] = 4 * inner * s * (odd_slope - even_slope);
    slope[4] = 8 * outer * s * above * above * above;
  }

  /// The first `beyond` weights are of nodes before the first.
  ASSAY_INLINE static void fold_lower(std::int32_t beyond, double* w) {
    for (int j = 1; j <= beyond; ++j) {
      w[beyond] += 2 * w[beyond - j];
      w[beyond + j] -= w[beyond - j];
    }
    for (int k = 0; k < width; ++k) w[k] = k + beyond < width ? w[k + beyond] : 0;
  }

  /// The last `beyond` weights are of nodes after the last. Of a cubic on the edge itself the second of two is zero,
  /// and its image is not here.
  ASSAY_INLINE static void fold_upper(std::int32_t beyond, double* w) {
    const int last = width - 1 - beyond;
    for (int j = 1; j <= beyond && j <= last; ++j) {
      w[last] += 2 * w[last + j];
      w[last - j] -= w[last + j];
    }
    for (int k = width - 1; k >= 0; --k) w[k] = k >= beyond ? w[k - beyond] : 0;
  }
};

template <int Dim>
using Bspline2Basis = BsplineBasis<Dim, 2>;
template <int Dim>
using Bspline3Basis = BsplineBasis<Dim, 3>;
template <int Dim>
using Bspline4Basis = BsplineBasis<Dim, 4>;

}  // namespace assay::mpm
