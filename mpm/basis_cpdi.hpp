// SPDX-License-Identifier: BSD-3-Clause
// CPDI (R4 in two dimensions): convected particle domains that stay parallelograms. Ref. [2] of the paper.
//
// Corners x_c = x + F (xi_c half), xi_c = (+-1, ...). phi_ip = 2^-Dim sum_c N_i(x_c);
// grad phi_ip = sum_c N_i(x_c) g_c with g_c = 2^-Dim F^-T (xi_c / half): the gradient of the interpolant between the
// corners, averaged over the domain.
#pragma once

#include "mpm/corners.hpp"

namespace assay::mpm {

template <int Dim>
class CpdiBasis {
 public:
  static constexpr int corners = 1 << Dim;
  static constexpr const char* name = "cpdi";
  static constexpr bool uses_deformation = true;
  static constexpr std::size_t domain_components = Dim * Dim;
  static constexpr double share = 1.0 / corners;
  /// Bytes of the weights a particle.
  static constexpr std::size_t bytes =
      corners * (sizeof(std::int32_t) + Dim * sizeof(double)) + Dim * Dim * sizeof(double);

  CpdiBasis(const GridGeometry<Dim>& grid, const Vec<Dim>& half_size, std::size_t particles)
      : locator_(grid), offsets_(corner_offsets(locator_)), half_(half_size), weights_(particles) {}

  bool place(std::size_t p, const Vec<Dim>& x, const Mat<Dim>& F) {
    Weights& w = weights_[p];
    const Mat<Dim> inverse = inverse_transpose<Dim>(F, determinant<Dim>(F));
    Mat<Dim> r;  // column d: half edge d of the domain
    for (std::size_t i = 0; i < Dim; ++i) {
      for (std::size_t d = 0; d < Dim; ++d) {
        r[i * Dim + d] = F[i * Dim + d] * half_[d];
        w.gradient[d * Dim + i] = share * inverse[i * Dim + d] / half_[d];
      }
    }
    return place_corners(w, x, r);
  }

  /// half: column d is half edge d of the reference domain, which need not follow the axes [m].
  bool place(std::size_t p, const Vec<Dim>& x, const Mat<Dim>& F, const Mat<Dim>& half) {
    Weights& w = weights_[p];
    Mat<Dim> r{};
    for (std::size_t i = 0; i < Dim; ++i) {
      for (std::size_t d = 0; d < Dim; ++d) {
        for (std::size_t k = 0; k < Dim; ++k) r[i * Dim + d] += F[i * Dim + k] * half[k * Dim + d];
      }
    }
    const Mat<Dim> inverse = inverse_transpose<Dim>(r, determinant<Dim>(r));
    for (std::size_t i = 0; i < Dim; ++i) {
      for (std::size_t d = 0; d < Dim; ++d) w.gradient[d * Dim + i] = share * inverse[i * Dim + d];
    }
    return place_corners(w, x, r);
  }

  template <int K, int G>
  void scatter(std::size_t p, const std::array<double, K>& A, const std::array<double, G * Dim>& B,
               GridField<K>& field) const {
    const Weights& w = weights_[p];
    std::array<double, G * Dim> slope{};  // B times each row of `gradient`
    for (std::size_t d = 0; d < Dim; ++d) {
      for (std::size_t k = 0; k < G; ++k) {
        for (std::size_t i = 0; i < Dim; ++i) slope[d * G + k] += B[k * Dim + i] * w.gradient[d * Dim + i];
      }
    }
    for (std::size_t c = 0; c < corners; ++c) {
      std::array<double, K> value;
      for (std::size_t k = 0; k < K; ++k) value[k] = share * A[k];
      for (std::size_t d = 0; d < Dim; ++d) {
        for (std::size_t k = 0; k < G; ++k) value[K - G + k] += (c >> d & 1) ? slope[d * G + k] : -slope[d * G + k];
      }
      const auto N = multilinear<Dim>(w.fraction[c]);
      for (std::size_t n = 0; n < corners; ++n) {
        double* node = field.node(static_cast<std::size_t>(w.node[c] + offsets_[n]));
        for (std::size_t k = 0; k < K; ++k) node[k] += N[n] * value[k];
      }
    }
  }

  template <int K, int G>
  void gather(std::size_t p, const GridField<K>& field, std::array<double, K>& value,
              std::array<double, G * Dim>& gradient) const {
    const Weights& w = weights_[p];
    value.fill(0);
    std::array<double, G * Dim> slope{};  // sum_c xi_c,d f_c
    for (std::size_t c = 0; c < corners; ++c) {
      const auto N = multilinear<Dim>(w.fraction[c]);
      std::array<double, K> corner{};
      for (std::size_t n = 0; n < corners; ++n) {
        const double* node = field.node(static_cast<std::size_t>(w.node[c] + offsets_[n]));
        for (std::size_t k = 0; k < K; ++k) corner[k] += N[n] * node[k];
      }
      for (std::size_t k = 0; k < K; ++k) value[k] += corner[k];
      for (std::size_t d = 0; d < Dim; ++d) {
        for (std::size_t k = 0; k < G; ++k) slope[d * G + k] += (c >> d & 1) ? corner[k] : -corner[k];
      }
    }
    for (std::size_t k = 0; k < K; ++k) value[k] *= share;
    gradient.fill(0);
    for (std::size_t k = 0; k < G; ++k) {
      for (std::size_t d = 0; d < Dim; ++d) {
        for (std::size_t i = 0; i < Dim; ++i) gradient[k * Dim + i] += slope[d * G + k] * w.gradient[d * Dim + i];
      }
    }
  }

  template <class Visitor>
  void each_node(std::size_t p, Visitor&& visitor) const {
    const Weights& w = weights_[p];
    std::array<Vec<Dim>, corners> cell;
    Vec<Dim> middle{};
    for (std::size_t c = 0; c < corners; ++c) {
      cell[c] = coordinates_of(locator_, w.node[c]);
      for (std::size_t d = 0; d < Dim; ++d) middle[d] += share * (cell[c][d] + w.fraction[c][d]);
    }
    for (std::size_t c = 0; c < corners; ++c) {
      const auto N = multilinear<Dim>(w.fraction[c]);
      for (std::size_t n = 0; n < corners; ++n) {
        Vec<Dim> r;
        for (std::size_t d = 0; d < Dim; ++d) {
          r[d] = (cell[c][d] + ((n >> d & 1) ? 1 : 0) - middle[d]) / locator_.inverse_spacing;
        }
        visitor(static_cast<std::size_t>(w.node[c] + offsets_[n]), share * N[n], r);
      }
    }
  }

 private:
  struct Weights {
    std::array<Vec<Dim>, corners> fraction;
    Mat<Dim> gradient;  ///< row d: 2^-Dim F^-T e_d / half_d; g_c = sum_d xi_c,d row_d
    std::array<std::int32_t, corners> node;
  };
  static_assert(sizeof(Weights) == bytes);

  bool place_corners(Weights& w, const Vec<Dim>& x, const Mat<Dim>& r) {
    bool inside = true;
    const Corners<Dim> at = corners_of<Dim>(x, r);
    for (std::size_t c = 0; c < corners; ++c) inside = locator_.cell_of(at[c], w.node[c], w.fraction[c]) && inside;
    return inside;
  }

  Locator<Dim> locator_;
  std::array<std::int32_t, corners> offsets_;
  Vec<Dim> half_;
  std::vector<Weights> weights_;
};

}  // namespace assay::mpm
