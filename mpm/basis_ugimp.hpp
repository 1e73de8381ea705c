// SPDX-License-Identifier: BSD-3-Clause
// uGIMP: the generalized interpolation material point method with particle domains that keep their size. Ref. [4].
//
// In each direction, with r = x - x_i and half size l <= h/2:
//   |r| < l:            1 - (r^2 + l^2) / (2 h l)
//   l <= |r| < h - l:   1 - |r| / h
//   h - l <= |r| < h+l: (h + l - |r|)^2 / (4 h l)
#pragma once

#include <cmath>

#include "mpm/basis_separable.hpp"

namespace assay::mpm {

template <int Dim>
class UgimpBasis : public SeparableBasis<Dim, 3> {
 public:
  static constexpr const char* name = "ugimp";
  static constexpr bool uses_deformation = false;
  static constexpr std::size_t domain_components = Dim;

  UgimpBasis(const GridGeometry<Dim>& grid, const Vec<Dim>& half_size, std::size_t particles)
      : SeparableBasis<Dim, 3>(grid, particles) {
    for (std::size_t d = 0; d < Dim; ++d) half_[d] = half_size[d] / grid.spacing;
  }

  bool place(std::size_t p, const Vec<Dim>& x, const Mat<Dim>&) { return place_with(p, x, half_); }

  bool place(std::size_t p, const Vec<Dim>& x, const Mat<Dim>&, const Vec<Dim>& half_size) {
    Vec<Dim> half;
    for (std::size_t d = 0; d < Dim; ++d) half[d] = half_size[d] * this->locator_.inverse_spacing;
    return place_with(p, x, half);
  }

 private:
  bool place_with(std::size_t p, const Vec<Dim>& x, const Vec<Dim>& half) {
    auto& w = this->weights_[p];
    Vec<Dim> shifted = x, fraction;  // to the cell of half a spacing below: its lower node is the first of the three
    for (std::size_t d = 0; d < Dim; ++d) shifted[d] -= 0.5 * spacing();
    if (!this->locator_.cell_of(shifted, w.node, fraction)) return false;
    for (std::size_t d = 0; d < Dim; ++d) {
      if (!(shifted[d] * this->locator_.inverse_spacing - this->locator_.first[d] < this->locator_.last_cell[d] - 1)) {
        return false;
      }
      const double l = half[d];            // in units of h, as r below
      const double r = fraction[d] - 0.5;  // from the middle node: [-1/2, 1/2)
      along(r + 1, l, w.value[d][0], w.slope[d][0]);
      along(r, l, w.value[d][1], w.slope[d][1]);
      along(r - 1, l, w.value[d][2], w.slope[d][2]);
    }
    return true;
  }

  double spacing() const { return 1 / this->locator_.inverse_spacing; }

  void along(double r, double l, double& value, double& slope) const {
    const double a = std::abs(r), sign = r < 0 ? -1 : 1;
    const double tail = 1 + l - a;
    if (a < l) {
      value = 1 - (r * r + l * l) / (2 * l);
      slope = -r / l;
    } else if (a < 1 - l) {
      value = 1 - a;
      slope = -sign;
    } else if (tail > 0) {
      value = tail * tail / (4 * l);
      slope = -sign * tail / (2 * l);
    } else {
      value = slope = 0;
    }
    slope *= this->locator_.inverse_spacing;
  }

  Vec<Dim> half_{};
};

}  // namespace assay::mpm
