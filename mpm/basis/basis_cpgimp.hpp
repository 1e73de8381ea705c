// SPDX-License-Identifier: BSD-3-Clause
// cpGIMP: uGIMP whose boxes stretch with the particle. Its half size along axis d is that of the reference times U_dd,
// U the right stretch: of the proposals of Coombs et al. (2020) the one that a rotation does not shrink. Ref. [4].
//
// The weight in a direction is the hat function averaged over [r - l, r + l], r = (x - x_i) / h, and so a difference of
// its integral. l is at most h: beyond, a particle would reach more than four nodes.
#pragma once

#include <algorithm>
#include <cmath>

#include "mpm/basis/basis_separable.hpp"

namespace assay::mpm {

/// Diagonal of U = (F^T F)^(1/2).
ASSAY_INLINE Vec<2> stretches_along_axes(const Mat<2>& F) {
  const double a = F[0] * F[0] + F[2] * F[2], b = F[1] * F[1] + F[3] * F[3];  // of C = F^T F
  const double J = std::abs(determinant<2>(F));
  const double trace_U = std::sqrt(a + b + 2 * J);  // Cayley and Hamilton: U = (C + J I) / (tr C + 2 J)^(1/2)
  return {(a + J) / trace_U, (b + J) / trace_U};
}

Vec<3> stretches_along_axes(const Mat<3>& F);

template <int Dim>
class CpgimpBasis : public SeparableBasis<CpgimpBasis<Dim>, Dim, 4, BoxPlace<Dim>> {
 public:
  static constexpr BasisTraits traits{
      .name = "cpGIMP",
      .uses_deformation = true,
      .why_not_total = "the boxes of cpgimp do not stretch in the reference configuration: take ugimp",
      .why_not_deformed = "the domains of cpGIMP stay aligned with the axes, so they overlap and leave gaps in shear"};

  CpgimpBasis(const GridGeometry<Dim>& grid, const Vec<Dim>& half_size, std::size_t particles)
      : SeparableBasis<CpgimpBasis<Dim>, Dim, 4, BoxPlace<Dim>>(grid, particles), half_(half_size) {}

  ASSAY_INLINE bool place(std::size_t p, const Vec<Dim>& x, const Mat<Dim>& F) { return place(p, x, F, half_); }

  /// At the edge of the grid the box must not reach over it.
  ASSAY_INLINE bool place(std::size_t p, const Vec<Dim>& x, const Mat<Dim>& F, const Vec<Dim>& half_size) {
    BoxPlace<Dim>& at = this->places_[p];
    const Vec<Dim> stretch = stretches_along_axes(F);
    bool inside = true;
    for (std::size_t d = 0; d < Dim; ++d) {
      const double along = x[d] * this->locator_.inverse_spacing - this->locator_.first[d];
      const double l = half_size[d] * stretch[d] * this->locator_.inverse_spacing;
      at.along[d] = along;
      at.half[d] = std::min(std::max(l, least), 1.0);
      inside = inside && along >= at.half[d] && along <= this->locator_.last_cell[d] - at.half[d] && std::isfinite(l);
    }
    if (!inside) at.along.fill(1);
    return inside;
  }

  /// The four nodes around the cell, none of them beyond the grid's first and last.
  ASSAY_INLINE void line(std::size_t p, std::size_t d, double* value, double* slope, std::int32_t& first) const {
    const BoxPlace<Dim>& at = this->places_[p];
    const std::int32_t before = static_cast<std::int32_t>(at.along[d]) - 1, last = this->count_[d] - 4;
    first = before < last ? before : last;
    first = first > 0 ? first : 0;
    const double along = at.along[d] - first, l = at.half[d], scale = 0.5 / l;
    for (int k = 0; k < 4; ++k) {
      double above = 0, below = 0, slope_above = 0, slope_below = 0;
      integral_of_hat(along - k + l, above, slope_above);
      integral_of_hat(along - k - l, below, slope_below);
      value[k] = (above - below) * scale;
      slope[k] = (slope_above - slope_below) * scale * this->locator_.inverse_spacing;
    }
  }

 private:
  static constexpr double least = 1e-6;  ///< of h: below, differences of the integral lose their digits

  /// The hat's integral from -infinity to r, and the hat itself.
  ASSAY_INLINE static void integral_of_hat(double r, double& integral, double& hat) {
    const double tail = 1 - (r < 0 ? -r : r);
    hat = tail > 0 ? tail : 0;
    const double half = 0.5 * hat * hat;
    integral = r < 0 ? half : 1 - half;
  }

  Vec<Dim> half_;
};

}  // namespace assay::mpm
