// SPDX-License-Identifier: BSD-3-Clause
// The material point method's first basis: multilinear shape functions at the particle. Ref. [3] of the paper.
#pragma once

#include "mpm/basis/basis_separable.hpp"

namespace assay::mpm {

template <int Dim>
class LinearBasis : public SeparableBasis<LinearBasis<Dim>, Dim, 2> {
 public:
  static constexpr BasisTraits traits{
      .smooth = false,
      .why_no_second_moment = "the second moment of linear functions vanishes at their nodes: set affine: gradient",
      .why_not_rotation = "the gradient of the linear basis jumps when a particle crosses into another cell",
      .why_not_deformed = "with the linear basis, a particle contributes only to the cell that it is in"};

  LinearBasis(const GridGeometry<Dim>& grid, const Vec<Dim>&, std::size_t particles)
      : SeparableBasis<LinearBasis<Dim>, Dim, 2>(grid, particles) {}

  ASSAY_INLINE bool place(std::size_t p, const Vec<Dim>& x, const Mat<Dim>&) {
    return this->locator_.inside(x, this->places_[p].along);
  }

  ASSAY_INLINE void line(std::size_t p, std::size_t d, double* value, double* slope, std::int32_t& first) const {
    const double along = this->along(p, d);
    first = static_cast<std::int32_t>(along);
    value[1] = along - first;
    value[0] = 1 - value[1];
    slope[1] = this->locator_.inverse_spacing;
    slope[0] = -slope[1];
  }
};

}  // namespace assay::mpm
