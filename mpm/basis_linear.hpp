// SPDX-License-Identifier: BSD-3-Clause
// The material point method's first basis: multilinear shape functions at the particle. Ref. [3] of the paper.
#pragma once

#include "mpm/basis_separable.hpp"

namespace assay::mpm {

template <int Dim>
class LinearBasis : public SeparableBasis<Dim, 2> {
 public:
  static constexpr const char* name = "linear";
  static constexpr bool uses_deformation = false;
  static constexpr std::size_t domain_components = 0;

  LinearBasis(const GridGeometry<Dim>& grid, const Vec<Dim>&, std::size_t particles)
      : SeparableBasis<Dim, 2>(grid, particles) {}

  bool place(std::size_t p, const Vec<Dim>& x, const Mat<Dim>&) {
    auto& w = this->weights_[p];
    Vec<Dim> fraction;
    if (!this->locator_.cell_of(x, w.node, fraction)) return false;
    for (std::size_t d = 0; d < Dim; ++d) {
      w.value[d] = {1 - fraction[d], fraction[d]};
      w.slope[d] = {-this->locator_.inverse_spacing, this->locator_.inverse_spacing};
    }
    return true;
  }
};

}  // namespace assay::mpm
