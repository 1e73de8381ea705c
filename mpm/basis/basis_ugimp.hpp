// SPDX-License-Identifier: BSD-3-Clause
// uGIMP: the generalized interpolation material point method with particle domains that keep their size. Ref. [4].
//
// In each direction, with r = x - x_i and half size l <= h/2:
//   |r| < l:            1 - (r^2 + l^2) / (2 h l)
//   l <= |r| < h - l:   1 - |r| / h
//   h - l <= |r| < h+l: (h + l - |r|)^2 / (4 h l)
// From the nearest node, |r| <= h/2, the nodes on its sides have these in one of two forms, and what they leave to one
// is its own:
//   r > l: r / h of the node above, none of the one below; |r| <= l: (l +- r)^2 / (4 h l)
#pragma once

#include "mpm/basis/basis_separable.hpp"

namespace assay::mpm {

template <int Dim>
class UgimpBasis : public SeparableBasis<UgimpBasis<Dim>, Dim, 3, BoxPlace<Dim>> {
 public:
  static constexpr BasisTraits traits{
      .name = "uGIMP",
      .why_not_deformed = "the domains of uGIMP keep their size and shape, so they overlap and leave gaps"};

  UgimpBasis(const GridGeometry<Dim>& grid, const Vec<Dim>& half_size, std::size_t particles)
      : SeparableBasis<UgimpBasis<Dim>, Dim, 3, BoxPlace<Dim>>(grid, particles), half_size_(half_size) {}

  ASSAY_INLINE bool place(std::size_t p, const Vec<Dim>& x, const Mat<Dim>& F) { return place(p, x, F, half_size_); }

  ASSAY_INLINE bool place(std::size_t p, const Vec<Dim>& x, const Mat<Dim>&, const Vec<Dim>& half_size) {
    BoxPlace<Dim>& at = this->places_[p];
    bool inside = true;
    for (std::size_t d = 0; d < Dim; ++d) {
      at.along[d] = x[d] * this->locator_.inverse_spacing - this->locator_.first[d];
      at.half[d] = half_size[d] * this->locator_.inverse_spacing;
      inside = inside && at.along[d] >= 0.5 && at.along[d] < this->locator_.last_cell[d] - 0.5;
    }
    if (!inside) at.along.fill(1);
    return inside;
  }

  ASSAY_INLINE void line(std::size_t p, std::size_t d, double* value, double* slope, std::int32_t& first) const {
    const BoxPlace<Dim>& at = this->places_[p];
    const double above_half = at.along[d] + 0.5;  // the nearest node: along is positive
    const auto middle = static_cast<std::int32_t>(above_half);
    const double r = at.along[d] - middle, l = at.half[d], s = this->locator_.inverse_spacing;
    first = middle - 1;
    const double half = 0.5 / l, below = l - r, above = l + r;
    const double lower = below > 0 ? below : 0, upper = above > 0 ? above : 0;
    value[0] = above < 0 ? -r : 0.5 * half * lower * lower;
    value[2] = below < 0 ? r : 0.5 * half * upper * upper;
    value[1] = 1 - value[0] - value[2];
    slope[0] = above < 0 ? -s : -s * half * lower;
    slope[2] = below < 0 ? s : s * half * upper;
    slope[1] = -slope[0] - slope[2];
  }

 private:
  Vec<Dim> half_size_;
};

}  // namespace assay::mpm
