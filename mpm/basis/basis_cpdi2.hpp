// SPDX-License-Identifier: BSD-3-Clause
// CPDI2 (Q4 in two dimensions): domains whose corners x_c move with the grid, one by one, so that neighbours which
// share corners leave no gaps. Sadeghirad, Brannon and Guilkey (2013).
//
// phi_ip = sum_c w_c N_i(x_c) and grad phi_ip = sum_c N_i(x_c) g_c: w_c and g_c are the averages of the multilinear
// corner functions Q_c and of their gradients over the domain.
#pragma once

#include "mpm/basis/basis_corners.hpp"
#include "mpm/basis/corners.hpp"

namespace assay::mpm {

template <int Dim>
class Cpdi2Basis : public CornerBasis<Cpdi2Basis<Dim>, Dim> {
  using Corner = CornerBasis<Cpdi2Basis<Dim>, Dim>;

 public:
  static constexpr int corners = 1 << Dim;
  static constexpr BasisTraits traits{
      .name = "CPDI2 (Q4)",
      .convects = true,
      .moves_corners = true,
      .why_not_total = "no corner moves in the reference configuration, where cpdi2 is cpdi: take that",
      .why_not_angular_momentum = "the centre of a quadrilateral moves slightly differently from its particle"};
  /// Bytes of the weights a particle.
  static constexpr std::size_t bytes = Corner::bytes_of_places + sizeof(CornerWeights<Dim>);

  Cpdi2Basis(const GridGeometry<Dim>& grid, const Vec<Dim>& half_size, std::size_t particles)
      : Corner(grid, particles), half_(half_size), weights_(particles) {}

  /// The domain of a particle that has been deformed as a whole.
  ASSAY_INLINE bool place(std::size_t p, const Vec<Dim>& x, const Mat<Dim>& F) {
    Mat<Dim> r;
    for (std::size_t k = 0; k < Dim * Dim; ++k) r[k] = F[k] * half_[k % Dim];
    return place(p, corners_of<Dim>(x, r));
  }

  /// False, too, where the domain is turned inside out.
  ASSAY_INLINE bool place(std::size_t p, const Corners<Dim>& x) {
    const CornerAverage<Dim> average = average_over(x);
    CornerWeights<Dim>& w = weights_[p];
    w.value = average.value;
    Pack<corners> at[Dim];
    for (std::size_t d = 0; d < Dim; ++d) {
      double along[corners];
      for (std::size_t c = 0; c < corners; ++c) {
        w.gradient[d][c] = average.gradient[c][d];
        along[c] = x[c][d];
      }
      load<corners>(at[d], along);
    }
    const bool inside = this->places_.place(p, at);
    return inside && average.volume > 0;
  }

  ASSAY_INLINE const CornerWeights<Dim>& weights(std::size_t p) const { return weights_[p]; }

 private:
  Vec<Dim> half_;
  std::vector<CornerWeights<Dim>> weights_;
};

}  // namespace assay::mpm
