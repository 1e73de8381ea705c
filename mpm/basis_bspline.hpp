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
class BsplineBasis : public SeparableBasis<Dim, Degree + 1> {
  static_assert(Degree == 2 || Degree == 3);

 public:
  static constexpr const char* name = Degree == 2 ? "bspline2" : "bspline3";
  static constexpr bool uses_deformation = false;
  static constexpr std::size_t domain_components = 0;

  BsplineBasis(const GridGeometry<Dim>& grid, const Vec<Dim>&, std::size_t particles)
      : SeparableBasis<Dim, width>(grid, particles), count_(grid.count) {}

  bool place(std::size_t p, const Vec<Dim>& x, const Mat<Dim>&) {
    auto& w = this->weights_[p];
    w.node = 0;
    for (std::size_t d = 0; d < Dim; ++d) {
      const double along = x[d] * this->locator_.inverse_spacing - this->locator_.first[d];
      if (!(along >= 0 && along <= this->locator_.last_cell[d])) return false;
      // Degree 2: around the nearest node; 3: around the cell.
      const auto middle = static_cast<std::int32_t>(Degree == 2 ? along + 0.5 : along);
      values_at(along - middle, w.value[d], w.slope[d]);
      std::int32_t first = middle - 1;
      if (first < 0) first = fold_lower(w.value[d], w.slope[d]);
      if (first + width > count_[d]) first = fold_upper(first, count_[d], w.value[d], w.slope[d]);
      w.node += first * this->locator_.stride[d];
    }
    return true;
  }

 private:
  static constexpr int width = Degree + 1;
  using Line = std::array<double, static_cast<std::size_t>(width)>;

  void values_at(double f, Line& value, Line& slope) const {
    const double s = this->locator_.inverse_spacing;
    if constexpr (Degree == 2) {
      value = {0.5 * (0.5 - f) * (0.5 - f), 0.75 - f * f, 0.5 * (0.5 + f) * (0.5 + f)};
      slope = {s * (f - 0.5), -2 * s * f, s * (f + 0.5)};
    } else {
      const double g = 1 - f;
      value = {g * g * g / 6, (4 + f * f * (3 * f - 6)) / 6, (4 + g * g * (3 * g - 6)) / 6, f * f * f / 6};
      slope = {-0.5 * s * g * g, s * f * (1.5 * f - 2), -s * g * (1.5 * g - 2), 0.5 * s * f * f};
    }
  }

  /// The first weight is of node -1. Returns the first node.
  static std::int32_t fold_lower(Line& value, Line& slope) {
    for (Line* line : {&value, &slope}) {
      Line& w = *line;
      w[1] += 2 * w[0];
      w[2] -= w[0];
      for (std::size_t k = 0; k + 1 < w.size(); ++k) w[k] = w[k + 1];
      w.back() = 0;
    }
    return 0;
  }

  /// One or two of the last weights are of nodes beyond the last; two only where a cubic stands on the edge itself, and
  /// the second is zero there.
  static std::int32_t fold_upper(std::int32_t first, std::int32_t count, Line& value, Line& slope) {
    while (first + width > count) {
      const auto beyond = static_cast<std::size_t>(count - first);
      for (Line* line : {&value, &slope}) {
        Line& w = *line;
        if (beyond < w.size()) {
          w[beyond - 1] += 2 * w[beyond];
          w[beyond - 2] -= w[beyond];
          for (std::size_t k = beyond; k > 0; --k) w[k] = w[k - 1];
          w[0] = 0;
        }
      }
      --first;
    }
    return first;
  }

  std::array<std::int32_t, Dim> count_;
};

template <int Dim>
using Bspline2Basis = BsplineBasis<Dim, 2>;
template <int Dim>
using Bspline3Basis = BsplineBasis<Dim, 3>;

}  // namespace assay::mpm
