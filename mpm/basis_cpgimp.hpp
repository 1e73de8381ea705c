// SPDX-License-Identifier: BSD-3-Clause
// cpGIMP: uGIMP whose boxes stretch with the particle. Its half size along axis d is that of the reference times U_dd,
// U the right stretch: of the proposals of Coombs et al. (2020) the one that a rotation does not shrink. Ref. [4].
//
// The weight in a direction is the hat function averaged over [r - l, r + l], r = (x - x_i) / h, and so a difference of
// its integral. l is at most h: beyond, a particle would reach more than four nodes.
#pragma once

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "mpm/basis_separable.hpp"

namespace assay::mpm {

/// Diagonal of U = (F^T F)^(1/2).
template <int Dim>
Vec<Dim> stretches_along_axes(const Mat<Dim>& F) {
  using Matrix = Eigen::Matrix<double, Dim, Dim, Eigen::RowMajor>;
  const Eigen::Map<const Matrix> gradient(F.data());
  const Matrix C = gradient.transpose() * gradient;
  Vec<Dim> diagonal;
  if constexpr (Dim == 2) {  // Cayley and Hamilton: U = (C + J I) / (tr C + 2 J)^(1/2)
    const double J = std::sqrt(std::max(0.0, C.determinant())), trace_U = std::sqrt(C.trace() + 2 * J);
    for (int d = 0; d < 2; ++d) diagonal[static_cast<std::size_t>(d)] = (C(d, d) + J) / trace_U;
  } else {
    const Matrix U = Eigen::SelfAdjointEigenSolver<Matrix>(C).operatorSqrt();
    for (int d = 0; d < Dim; ++d) diagonal[static_cast<std::size_t>(d)] = U(d, d);
  }
  return diagonal;
}

template <int Dim>
class CpgimpBasis : public SeparableBasis<Dim, 4> {
 public:
  static constexpr const char* name = "cpgimp";
  static constexpr bool uses_deformation = true;
  static constexpr std::size_t domain_components = Dim;

  CpgimpBasis(const GridGeometry<Dim>& grid, const Vec<Dim>& half_size, std::size_t particles)
      : SeparableBasis<Dim, 4>(grid, particles), count_(grid.count), half_(half_size) {}

  bool place(std::size_t p, const Vec<Dim>& x, const Mat<Dim>& F) { return place(p, x, F, half_); }

  bool place(std::size_t p, const Vec<Dim>& x, const Mat<Dim>& F, const Vec<Dim>& half_size) {
    auto& w = this->weights_[p];
    const Vec<Dim> stretch = stretches_along_axes<Dim>(F);
    w.node = 0;
    for (std::size_t d = 0; d < Dim; ++d) {
      const double along = x[d] * this->locator_.inverse_spacing - this->locator_.first[d];
      const double l = half_size[d] * stretch[d] * this->locator_.inverse_spacing;
      if (!(along >= 0 && along <= this->locator_.last_cell[d]) || !std::isfinite(l)) return false;
      const auto cell = static_cast<std::int32_t>(along);
      for (std::size_t k = 0; k < 4; ++k) {
        average(along - cell + 1 - static_cast<double>(k), std::clamp(l, least, 1.0), w.value[d][k], w.slope[d][k]);
      }
      std::int32_t first = cell - 1;
      if (!shift_inside(first, count_[d], w.value[d], w.slope[d])) return false;
      w.node += first * this->locator_.stride[d];
    }
    return true;
  }

 private:
  using Line = std::array<double, 4>;
  static constexpr double least = 1e-6;  ///< of h: below, differences of the integral lose their digits

  static double hat(double r) { return std::max(0.0, 1 - std::abs(r)); }
  static double integral_of_hat(double r) {
    const double tail = std::max(0.0, 1 - std::abs(r));
    return r < 0 ? 0.5 * tail * tail : 1 - 0.5 * tail * tail;
  }
  void average(double r, double l, double& value, double& slope) const {
    value = (integral_of_hat(r + l) - integral_of_hat(r - l)) / (2 * l);
    slope = (hat(r + l) - hat(r - l)) / (2 * l) * this->locator_.inverse_spacing;
  }

  /// Where the four nodes reach over an edge of the grid with weights of zero; false where they have any.
  static bool shift_inside(std::int32_t& first, std::int32_t count, Line& value, Line& slope) {
    for (; first < 0; ++first) {
      if (value[0] != 0 || slope[0] != 0) return false;
      for (Line* line : {&value, &slope}) std::rotate(line->begin(), line->begin() + 1, line->end());
    }
    for (; first + 4 > count; --first) {
      if (value[3] != 0 || slope[3] != 0) return false;
      for (Line* line : {&value, &slope}) std::rotate(line->begin(), line->begin() + 3, line->end());
    }
    return true;
  }

  std::array<std::int32_t, Dim> count_;
  Vec<Dim> half_;
};

}  // namespace assay::mpm
