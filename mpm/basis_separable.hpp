// SPDX-License-Identifier: BSD-3-Clause
// Bases whose weights are products of one-dimensional ones on Width neighbouring nodes.
#pragma once

#include "mpm/basis.hpp"

namespace assay::mpm {

template <int Dim, int Width>
class SeparableBasis {
 public:
  /// Bytes of the weights a particle.
  static constexpr std::size_t bytes = 2 * Dim * Width * sizeof(double) + sizeof(std::int64_t);

  template <int K, int G>
  void scatter(std::size_t p, const std::array<double, K>& A, const std::array<double, G * Dim>& B,
               GridField<K>& field) const {
    visit(weights_[p], [&](std::size_t i, double value, const Vec<Dim>& slope) {
      double* node = field.node(i);
      for (std::size_t k = 0; k < K; ++k) node[k] += value * A[k];
      for (std::size_t k = 0; k < G; ++k) {
        for (std::size_t d = 0; d < Dim; ++d) node[K - G + k] += B[k * Dim + d] * slope[d];
      }
    });
  }

  template <int K, int G>
  void gather(std::size_t p, const GridField<K>& field, std::array<double, K>& value,
              std::array<double, G * Dim>& gradient) const {
    value.fill(0);
    gradient.fill(0);
    visit(weights_[p], [&](std::size_t i, double weight, const Vec<Dim>& slope) {
      const double* node = field.node(i);
      for (std::size_t k = 0; k < K; ++k) value[k] += weight * node[k];
      for (std::size_t k = 0; k < G; ++k) {
        for (std::size_t d = 0; d < Dim; ++d) gradient[k * Dim + d] += node[k] * slope[d];
      }
    });
  }

  template <class Visitor>
  void each_node(std::size_t p, Visitor&& visitor) const {
    const Weights& w = weights_[p];
    std::array<std::array<double, Width>, Dim> r;
    for (std::size_t d = 0; d < Dim; ++d) {
      double middle = 0;
      for (std::size_t i = 0; i < Width; ++i) middle += w.value[d][i] * static_cast<double>(i);
      for (std::size_t i = 0; i < Width; ++i) {
        r[d][i] = (static_cast<double>(i) - middle) / locator_.inverse_spacing;
      }
    }
    const auto base = static_cast<std::size_t>(w.node);
    const auto& v = w.value;
    if constexpr (Dim == 2) {
      for (std::size_t j = 0; j < Width; ++j) {
        for (std::size_t i = 0; i < Width; ++i) {
          visitor(base + i + j * stride(1), v[0][i] * v[1][j], Vec<2>{r[0][i], r[1][j]});
        }
      }
    } else {
      for (std::size_t k = 0; k < Width; ++k) {
        for (std::size_t j = 0; j < Width; ++j) {
          for (std::size_t i = 0; i < Width; ++i) {
            visitor(base + i + j * stride(1) + k * stride(2), v[0][i] * v[1][j] * v[2][k],
                    Vec<3>{r[0][i], r[1][j], r[2][k]});
          }
        }
      }
    }
  }

 protected:
  struct Weights {
    std::array<std::array<double, Width>, Dim> value, slope;
    alignas(8) std::int32_t node;  ///< the first of them
  };

  SeparableBasis(const GridGeometry<Dim>& grid, std::size_t particles) : locator_(grid), weights_(particles) {}

  static_assert(sizeof(Weights) == bytes);

  Locator<Dim> locator_;
  std::vector<Weights> weights_;

 private:
  template <class Visitor>
  void visit(const Weights& w, Visitor&& visitor) const {
    const auto base = static_cast<std::size_t>(w.node);
    const auto& v = w.value;
    const auto& s = w.slope;
    if constexpr (Dim == 2) {
      for (std::size_t j = 0; j < Width; ++j) {
        for (std::size_t i = 0; i < Width; ++i) {
          visitor(base + i + j * stride(1), v[0][i] * v[1][j], Vec<2>{s[0][i] * v[1][j], v[0][i] * s[1][j]});
        }
      }
    } else {
      for (std::size_t k = 0; k < Width; ++k) {
        for (std::size_t j = 0; j < Width; ++j) {
          for (std::size_t i = 0; i < Width; ++i) {
            visitor(base + i + j * stride(1) + k * stride(2), v[0][i] * v[1][j] * v[2][k],
                    Vec<3>{s[0][i] * v[1][j] * v[2][k], v[0][i] * s[1][j] * v[2][k], v[0][i] * v[1][j] * s[2][k]});
          }
        }
      }
    }
  }
  std::size_t stride(std::size_t d) const { return static_cast<std::size_t>(locator_.stride[d]); }
};

}  // namespace assay::mpm
