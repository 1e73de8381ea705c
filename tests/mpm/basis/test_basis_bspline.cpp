// SPDX-License-Identifier: BSD-3-Clause
// Twin: the recursion of Cox and de Boor on uniform knots; and the edge of the grid.
#include "tests/mpm/basis_cases.hpp"

namespace assay::mpm::test_basis_bspline {
namespace {

/// B-spline of a degree whose support begins at 0, knots one apart.
double de_boor(int degree, double u) {
  if (degree == 0) return u >= 0 && u < 1 ? 1 : 0;
  return (u * de_boor(degree - 1, u) + (degree + 1 - u) * de_boor(degree - 1, u - 1)) / degree;
}

double de_boor_slope(int degree, double u) { return de_boor(degree - 1, u) - de_boor(degree - 1, u - 1); }

template <class Case>
struct BsplineBasisTest : testing::Test, BasisFixture<Case> {
  static constexpr std::size_t Dim = Case::Dim;
  static constexpr int degree = Case::Basis::nodes_across - 1;

  /// Distance of x from where the support of node i's function begins, in spacings.
  double along(std::size_t i, std::size_t d) const {
    return (this->x[d] - this->node_position(i)[d]) / this->grid.spacing + 0.5 * (degree + 1);
  }

  void place_at(const Vec<Dim>& at) {
    Mat<Dim> identity{};
    for (std::size_t d = 0; d < Dim; ++d) identity[d * Dim + d] = 1;
    this->x = at;
    ASSERT_TRUE(this->basis.place(0, at, identity));
  }
};
using EveryDegree =
    testing::Types<BasisCase<Bspline2Basis, 2>, BasisCase<Bspline3Basis, 2>, BasisCase<Bspline4Basis, 2>,
                   BasisCase<Bspline2Basis, 3>, BasisCase<Bspline3Basis, 3>, BasisCase<Bspline4Basis, 3>>;
TYPED_TEST_SUITE(BsplineBasisTest, EveryDegree, BasisCaseName);

TYPED_TEST(BsplineBasisTest, IsThatOfTheRecursion) {
  constexpr std::size_t N = TypeParam::Dim;
  for (int k = 0; k < 50; ++k) {
    this->place_at_random();
    const auto w = this->weights();
    for (std::size_t i = 0; i < w.nodes(); ++i) {
      double value = 1;
      for (std::size_t d = 0; d < N; ++d) value *= de_boor(this->degree, this->along(i, d));
      EXPECT_NEAR(w.node(i)[0], value, round_off);
      for (std::size_t d = 0; d < N; ++d) {
        double slope = de_boor_slope(this->degree, this->along(i, d)) / this->grid.spacing;
        for (std::size_t e = 0; e < N; ++e) slope *= e == d ? 1 : de_boor(this->degree, this->along(i, e));
        EXPECT_NEAR(w.node(i)[1 + d], slope, round_off / this->grid.spacing);
      }
    }
  }
}

// In the last cells, and on the edge itself, the functions sum to one, reproduce linear fields, and are those of the
// edge alone there.
TYPED_TEST(BsplineBasisTest, AtTheEdgeOfTheGridStaysComplete) {
  constexpr std::size_t N = TypeParam::Dim;
  for (const double share : {0.0, 1e-14, 0.1, 0.49, 0.5, 0.51, 0.99, 1.0, 1.3, 1.7}) {
    for (const bool upper : {false, true}) {
      Vec<N> at;
      for (std::size_t d = 0; d < N; ++d) {
        const auto last = this->grid.count[d] - 1;
        const double edge = this->grid.coordinate(static_cast<int>(d), upper ? last : 0);
        at[d] = edge + (upper ? -share : share) * this->grid.spacing;
        at[d] = std::clamp(at[d], this->grid.coordinate(static_cast<int>(d), 0),
                           this->grid.coordinate(static_cast<int>(d), last) * (1 - 1e-15));
      }
      this->place_at(at);
      const auto w = this->weights();
      double sum = 0, largest = 0;
      Vec<N> position{}, gradient{};
      Mat<N> identity{};
      for (std::size_t i = 0; i < w.nodes(); ++i) {
        const Vec<N> node = this->node_position(i);
        EXPECT_GE(w.node(i)[0], -round_off);
        sum += w.node(i)[0];
        largest = std::max(largest, w.node(i)[0]);
        for (std::size_t d = 0; d < N; ++d) {
          position[d] += w.node(i)[0] * node[d];
          gradient[d] += w.node(i)[1 + d];
          for (std::size_t e = 0; e < N; ++e) identity[d * N + e] += node[d] * w.node(i)[1 + e];
        }
      }
      EXPECT_NEAR(sum, 1, round_off) << share;
      for (std::size_t d = 0; d < N; ++d) {
        EXPECT_NEAR(position[d], at[d], round_off) << share;
        EXPECT_NEAR(gradient[d], 0, round_off / this->grid.spacing) << share;
        for (std::size_t e = 0; e < N; ++e) EXPECT_NEAR(identity[d * N + e], d == e, 10 * round_off) << share;
      }
      if (share == 0) {
        EXPECT_NEAR(largest, 1, round_off);
      }
    }
  }
}

}  // namespace
}  // namespace assay::mpm::test_basis_bspline
