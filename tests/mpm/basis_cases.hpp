// SPDX-License-Identifier: BSD-3-Clause
// Every basis in every dimension, random particles, and the weights read back through `scatter`.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <tuple>

#include "mpm/setup/with_basis.hpp"

namespace assay::mpm {

template <template <int> class B, int D>
struct BasisCase {
  static constexpr int Dim = D;
  using Basis = B<D>;
};

template <class... Cases>
testing::Types<Cases...> types_of(std::tuple<Cases...>);
#define ASSAY_BASIS(word, type, header) std::tuple<BasisCase<type, 2>, BasisCase<type, 3>>(),
using EveryBasis = decltype(types_of(std::tuple_cat(
#include "mpm/basis/bases.inc"
    std::tuple<>())));
#undef ASSAY_BASIS

struct BasisCaseName {
  template <class T>
  static std::string GetName(int) {
    const std::string dimension = std::to_string(T::Dim) + "d";
#define ASSAY_BASIS(word, type, header) \
  if (std::is_same_v<typename T::Basis, type<T::Dim>>) return #word + dimension;
#include "mpm/basis/bases.inc"
#undef ASSAY_BASIS
    return dimension;
  }
};

/// Doubles in [-1, 1), the same on every machine.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double operator()() { return std::ldexp(static_cast<double>(engine_() >> 11), -52) - 1; }
  template <std::size_t N>
  std::array<double, N> array(double scale) {
    std::array<double, N> values;
    for (double& v : values) v = scale * (*this)();
    return values;
  }

 private:
  std::mt19937_64 engine_;
};

/// Of the particle p, the nodes with moments w_i r_i in place of slopes.
template <class Basis>
typename Basis::Nodes nodes_with_moments(const Basis& basis, std::size_t p) {
  typename Basis::Nodes nodes;
  basis.expand(p, 1, nodes);
  basis.slopes_to_moments(1, nodes);
  return nodes;
}

/// Adds w_i (A + (0, C r_i)): C acts on the last Dim.
template <int K, int Dim, class Basis>
void scatter_affine(const Basis& basis, std::size_t p, const std::array<double, K>& A, const Mat<Dim>& C,
                    double* field) {
  const auto nodes = nodes_with_moments(basis, p);
  NodePacks<K, Dim> value;
  value.template set<Dim>(A, C);
  basis.template add_affine<K>(nodes, 0, value, field);
}

/// sum_i w_i f_i (x) r_i of the first Dim components.
template <int K, int Dim, class Basis>
Mat<Dim> first_moment(const Basis& basis, std::size_t p, const double* field) {
  return basis.template moment<K>(nodes_with_moments(basis, p), 0, field);
}

/// D = sum_i w_i r_i (x) r_i [m^2].
template <int Dim, class Basis>
Mat<Dim> second_moment(const Basis& basis, std::size_t p) {
  typename Basis::Nodes nodes;
  basis.expand(p, 1, nodes);
  return basis.spread(nodes, 0);
}

/// A strongly deformed F: rotation (by any angle, about all axes in turn) times shear up to 4 times stretch by 1/2
/// to 2.
template <int Dim>
Mat<Dim> random_deformation(Random& random) {
  const auto times = [](const Mat<Dim>& a, const Mat<Dim>& b) {
    Mat<Dim> c{};
    for (std::size_t i = 0; i < Dim; ++i) {
      for (std::size_t j = 0; j < Dim; ++j) {
        for (std::size_t k = 0; k < Dim; ++k) c[i * Dim + j] += a[i * Dim + k] * b[k * Dim + j];
      }
    }
    return c;
  };
  Mat<Dim> F{};
  for (std::size_t d = 0; d < Dim; ++d) F[d * Dim + d] = std::exp2(random());
  Mat<Dim> shear{};
  for (std::size_t d = 0; d < Dim; ++d) shear[d * Dim + d] = 1;
  shear[1] = 4 * random();
  F = times(shear, F);
  for (std::size_t axis = 0; axis < (Dim == 2 ? 1 : 3); ++axis) {
    const std::size_t i = axis, j = (axis + 1) % Dim;
    const double angle = 3.2 * random();
    Mat<Dim> Q{};
    for (std::size_t d = 0; d < Dim; ++d) Q[d * Dim + d] = 1;
    Q[i * Dim + i] = Q[j * Dim + j] = std::cos(angle);
    Q[i * Dim + j] = -std::sin(angle);
    Q[j * Dim + i] = std::sin(angle);
    F = times(Q, F);
  }
  return F;
}

/// A grid with room around the particles, its origin inside; domains of unequal half sizes.
template <class Case>
struct BasisFixture {
  static constexpr int Dim = Case::Dim;
  static constexpr std::size_t size = Dim;
  static constexpr double reach = 0.3;  ///< of positions from the origin [m]

  GridGeometry<Dim> grid;
  Vec<Dim> half{};
  Random random{2026};
  typename Case::Basis basis;
  Vec<Dim> x{};
  Mat<Dim> F{};

  BasisFixture() : grid(make_grid()), half(make_half(grid.spacing)), basis(grid, half, 1) {}

  void place_at_random() {
    x = random.template array<size>(reach);
    F = random_deformation<Dim>(random);
    ASSERT_TRUE(basis.place(0, x, F));
  }

  /// phi_ip and grad phi_ip of the placed particle, by node.
  GridField<Dim + 1> weights() const {
    GridField<Dim + 1> field;
    field.allocate(grid.nodes());
    std::array<double, Dim + 1> A{1};
    Mat<Dim> identity{};
    for (std::size_t d = 0; d < size; ++d) identity[d * size + d] = 1;
    basis.template scatter<Dim + 1, Dim>(0, A, identity, field.data());
    return field;
  }

  Vec<Dim> node_position(std::size_t i) const {
    Vec<Dim> position;
    for (int d = 0; d < Dim; ++d) {
      const auto k = static_cast<std::size_t>(d), count = static_cast<std::size_t>(grid.count[k]);
      position[k] = grid.coordinate(d, static_cast<std::int32_t>(i % count));
      i /= count;
    }
    return position;
  }

  /// The plain hat function of node i at a point.
  double hat(std::size_t i, const Vec<Dim>& at) const {
    const Vec<Dim> node = node_position(i);
    double product = 1;
    for (std::size_t d = 0; d < size; ++d) product *= std::max(0.0, 1 - std::abs(at[d] - node[d]) / grid.spacing);
    return product;
  }

  /// Its gradient inside a cell.
  Vec<Dim> hat_gradient(std::size_t i, const Vec<Dim>& at) const {
    const Vec<Dim> node = node_position(i);
    Vec<Dim> gradient;
    for (std::size_t d = 0; d < size; ++d) {
      gradient[d] = 1;
      for (std::size_t k = 0; k < size; ++k) {
        const double r = (at[k] - node[k]) / grid.spacing;
        gradient[d] *= std::abs(r) >= 1 ? 0 : k != d ? 1 - std::abs(r) : (r < 0 ? 1 : -1) / grid.spacing;
      }
    }
    return gradient;
  }

 private:
  static GridGeometry<Dim> make_grid() {
    GridGeometry<Dim> grid;
    grid.spacing = 0.1;
    for (std::size_t d = 0; d < size; ++d) {
      grid.first[d] = -8 - static_cast<std::int32_t>(d);
      grid.count[d] = 18 + static_cast<std::int32_t>(d);
    }
    return grid;
  }
  static Vec<Dim> make_half(double h) {
    Vec<Dim> half;
    for (std::size_t d = 0; d < size; ++d) half[d] = h / (2.0 * (static_cast<double>(d) + 1));  // 1, 2, 3 a cell
    return half;
  }
};

/// Round-off of a sum of products of cell coordinates (at most ~20) with weights: some ulp of those, times the terms.
inline constexpr double round_off = 1e3 * std::numeric_limits<double>::epsilon();

}  // namespace assay::mpm
