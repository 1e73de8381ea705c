// SPDX-License-Identifier: BSD-3-Clause
// CPDI (R4 in two dimensions): convected particle domains that stay parallelograms. Ref. [2] of the paper.
//
// Corners x_c = x + F (xi_c half), xi_c = (+-1, ...). phi_ip = 2^-Dim sum_c N_i(x_c);
// grad phi_ip = sum_c N_i(x_c) g_c with g_c = 2^-Dim F^-T (xi_c / half): the gradient of the interpolant between the
// corners, averaged over the domain.
#pragma once

#include "mpm/basis/basis_corners.hpp"

namespace assay::mpm {

template <int Dim>
class CpdiBasis : public CornerBasis<CpdiBasis<Dim>, Dim> {
  using Corner = CornerBasis<CpdiBasis<Dim>, Dim>;

 public:
  static constexpr int corners = 1 << Dim;
  static constexpr BasisTraits traits{
      .name = "CPDI (R4)",
      .convects = true,
      .uses_deformation = true,
      .why_not_jittered = "domains of CPDI that are moved independently overlap and leave gaps"};
  static constexpr std::size_t domain_components = Dim * Dim;
  static constexpr double share = 1.0 / corners;
  /// Bytes of the weights a particle.
  static constexpr std::size_t bytes = Corner::bytes_of_places + Dim * Dim * sizeof(double);

  CpdiBasis(const GridGeometry<Dim>& grid, const Vec<Dim>& half_size, std::size_t particles)
      : Corner(grid, particles), gradients_(particles) {
    for (std::size_t d = 0; d < Dim; ++d) half_[d * Dim + d] = half_size[d];
  }

  ASSAY_INLINE bool place(std::size_t p, const Vec<Dim>& x, const Mat<Dim>& F) { return place(p, x, F, half_); }

  /// half: column d is half edge d of the reference domain, which need not follow the axes [m].
  ASSAY_INLINE bool place(std::size_t p, const Vec<Dim>& x, const Mat<Dim>& F, const Mat<Dim>& half) {
    Mat<Dim> r{};  // column d: half edge d of the domain
    for (std::size_t i = 0; i < Dim; ++i) {
      for (std::size_t d = 0; d < Dim; ++d) {
        for (std::size_t k = 0; k < Dim; ++k) r[i * Dim + d] += F[i * Dim + k] * half[k * Dim + d];
      }
    }
    const Mat<Dim> inverse = inverse_transpose<Dim>(r, determinant<Dim>(r));
    for (std::size_t i = 0; i < Dim; ++i) {
      for (std::size_t d = 0; d < Dim; ++d) gradients_[p][d * Dim + i] = share * inverse[i * Dim + d];
    }
    Pack<corners> at[Dim];
    for (std::size_t i = 0; i < Dim; ++i) {
      at[i] = x[i] + Pack<corners>{};
      for (std::size_t d = 0; d < Dim; ++d) at[i] += signs(d) * r[i * Dim + d];
    }
    return this->places_.place(p, at);
  }

  ASSAY_INLINE CornerWeights<Dim> weights(std::size_t p) const {
    CornerWeights<Dim> w;
    w.value.fill(share);
    for (std::size_t i = 0; i < Dim; ++i) {
      Pack<corners> g{};
      for (std::size_t d = 0; d < Dim; ++d) g += signs(d) * gradients_[p][d * Dim + i];
      store<corners>(w.gradient[i].data(), g);
    }
    return w;
  }

 private:
  /// xi_c,d
  ASSAY_INLINE static Pack<corners> signs(std::size_t d) {
    double sign[corners];
    for (std::size_t c = 0; c < corners; ++c) sign[c] = (c >> d & 1) ? 1 : -1;
    Pack<corners> found;
    load<corners>(found, sign);
    return found;
  }

  Mat<Dim> half_{};
  std::vector<Mat<Dim>> gradients_;  ///< row d: 2^-Dim F^-T e_d / half_d; g_c = sum_d xi_c,d row_d
};

}  // namespace assay::mpm
