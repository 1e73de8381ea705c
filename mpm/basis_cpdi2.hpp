// SPDX-License-Identifier: BSD-3-Clause
// CPDI2 (Q4 in two dimensions): domains whose corners x_c move with the grid, one by one, so that neighbours which
// share corners leave no gaps. Sadeghirad, Brannon and Guilkey (2013).
//
// phi_ip = sum_c w_c N_i(x_c) and grad phi_ip = sum_c N_i(x_c) g_c: w_c and g_c are the averages of the multilinear
// corner functions Q_c and of their gradients over the domain.
#pragma once

#include "mpm/corner_average.hpp"

namespace assay::mpm {

template <int Dim>
class Cpdi2Basis {
 public:
  static constexpr int corners = 1 << Dim;
  static constexpr const char* name = "cpdi2";
  static constexpr bool uses_deformation = false;
  static constexpr bool moves_corners = true;
  static constexpr std::size_t domain_components = 0;  ///< the corners are the domain
  /// Bytes of the weights a particle.
  static constexpr std::size_t bytes = corners * ((1 + 2 * Dim) * sizeof(double) + sizeof(std::int32_t));

  Cpdi2Basis(const GridGeometry<Dim>& grid, const Vec<Dim>& half_size, std::size_t particles)
      : locator_(grid), offsets_(corner_offsets(locator_)), half_(half_size), weights_(particles) {}

  /// The domain of a particle that has been deformed as a whole.
  bool place(std::size_t p, const Vec<Dim>& x, const Mat<Dim>& F) {
    Mat<Dim> r;
    for (std::size_t k = 0; k < Dim * Dim; ++k) r[k] = F[k] * half_[k % Dim];
    return place(p, corners_of<Dim>(x, r));
  }

  /// False, too, where the domain is turned inside out.
  bool place(std::size_t p, const Corners<Dim>& x) {
    Weights& w = weights_[p];
    const CornerAverage<Dim> average = average_over(x);
    w.value = average.value;
    w.gradient = average.gradient;
    bool good = average.volume > 0;
    for (std::size_t c = 0; c < corners; ++c) good = locator_.cell_of(x[c], w.node[c], w.fraction[c]) && good;
    return good;
  }

  template <int K, int G>
  void scatter(std::size_t p, const std::array<double, K>& A, const std::array<double, G * Dim>& B,
               GridField<K>& field) const {
    const Weights& w = weights_[p];
    for (std::size_t c = 0; c < corners; ++c) {
      std::array<double, K> value;
      for (std::size_t k = 0; k < K; ++k) value[k] = w.value[c] * A[k];
      for (std::size_t k = 0; k < G; ++k) {
        for (std::size_t i = 0; i < Dim; ++i) value[K - G + k] += B[k * Dim + i] * w.gradient[c][i];
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
    gradient.fill(0);
    for (std::size_t c = 0; c < corners; ++c) {
      const std::array<double, K> corner = at_corner(w, c, field);
      for (std::size_t k = 0; k < K; ++k) value[k] += w.value[c] * corner[k];
      for (std::size_t k = 0; k < G; ++k) {
        for (std::size_t i = 0; i < Dim; ++i) gradient[k * Dim + i] += corner[k] * w.gradient[c][i];
      }
    }
  }

  /// sum_i N_i(x_c) f_i at each corner.
  template <int K>
  std::array<std::array<double, K>, corners> at_corners(std::size_t p, const GridField<K>& field) const {
    std::array<std::array<double, K>, corners> values;
    for (std::size_t c = 0; c < corners; ++c) values[c] = at_corner(weights_[p], c, field);
    return values;
  }

  template <class Visitor>
  void each_node(std::size_t p, Visitor&& visitor) const {
    const Weights& w = weights_[p];
    std::array<Vec<Dim>, corners> cell;
    Vec<Dim> middle{};  // sum_c w_c x_c, by which no momentum drifts
    for (std::size_t c = 0; c < corners; ++c) {
      cell[c] = coordinates_of(locator_, w.node[c]);
      for (std::size_t d = 0; d < Dim; ++d) middle[d] += w.value[c] * (cell[c][d] + w.fraction[c][d]);
    }
    for (std::size_t c = 0; c < corners; ++c) {
      const auto N = multilinear<Dim>(w.fraction[c]);
      for (std::size_t n = 0; n < corners; ++n) {
        Vec<Dim> r;
        for (std::size_t d = 0; d < Dim; ++d) {
          r[d] = (cell[c][d] + ((n >> d & 1) ? 1 : 0) - middle[d]) / locator_.inverse_spacing;
        }
        visitor(static_cast<std::size_t>(w.node[c] + offsets_[n]), w.value[c] * N[n], r);
      }
    }
  }

 private:
  struct Weights {
    std::array<double, corners> value;       ///< w_c
    std::array<Vec<Dim>, corners> gradient;  ///< g_c
    std::array<Vec<Dim>, corners> fraction;  ///< of the corner in its cell
    std::array<std::int32_t, corners> node;  ///< at the lower corner of that cell
  };
  static_assert(sizeof(Weights) == bytes);

  template <int K>
  std::array<double, K> at_corner(const Weights& w, std::size_t c, const GridField<K>& field) const {
    const auto N = multilinear<Dim>(w.fraction[c]);
    std::array<double, K> value{};
    for (std::size_t n = 0; n < corners; ++n) {
      const double* node = field.node(static_cast<std::size_t>(w.node[c] + offsets_[n]));
      for (std::size_t k = 0; k < K; ++k) value[k] += N[n] * node[k];
    }
    return value;
  }

  Locator<Dim> locator_;
  std::array<std::int32_t, corners> offsets_;
  Vec<Dim> half_;
  std::vector<Weights> weights_;
};

}  // namespace assay::mpm
