// SPDX-License-Identifier: BSD-3-Clause
// Brute-force twin: the interpolant between the corners of the deformed domain, sum_c Q_c(x) N_i(x_c), averaged over
// the domain by quadrature; its gradient by central differences in x through the inverse map.
#include <Eigen/LU>

#include "tests/mpm/basis_cases.hpp"

namespace assay::mpm::test_basis_cpdi {
namespace {

template <class Case>
struct CpdiBasisTest : testing::Test, BasisFixture<Case> {
  static constexpr int Dim = Case::Dim;
  static constexpr std::size_t corners = 1 << Dim;
  using Vector = Eigen::Matrix<double, Dim, 1>;
  using Matrix = Eigen::Matrix<double, Dim, Dim>;

  /// d x / d xi: xi in [-1, 1]^Dim runs over the domain.
  Matrix map() const {
    Matrix M;
    for (int i = 0; i < Dim; ++i) {
      for (int d = 0; d < Dim; ++d) {
        M(i, d) = this->F[static_cast<std::size_t>(i * Dim + d)] * this->half[static_cast<std::size_t>(d)];
      }
    }
    return M;
  }
  static double sign(std::size_t c, int d) { return c >> d & 1 ? 1 : -1; }

  /// Q_c at xi.
  static double corner_function(std::size_t c, const Vector& xi) {
    double product = 1;
    for (int d = 0; d < Dim; ++d) product *= 0.5 * (1 + sign(c, d) * xi(d));
    return product;
  }

  double hat_at_corner(std::size_t i, std::size_t c) const {
    Vector xi;
    for (int d = 0; d < Dim; ++d) xi(d) = sign(c, d);
    const Vector offset = map() * xi;
    Vec<Dim> at = this->x;
    for (int d = 0; d < Dim; ++d) at[static_cast<std::size_t>(d)] += offset(d);
    return this->hat(i, at);
  }

  /// Q_c and its gradient averaged over the domain: midpoint rule in xi, exact for multilinear integrands.
  void averages(std::size_t c, double& value, Vector& gradient) const {
    constexpr int points = 4;
    const Matrix inverse = map().inverse();
    const double step = 1e-3 * this->grid.spacing;  // Q_c is quadratic (cubic in 3-D) along a line: error below 1e-6
    value = 0;
    gradient.setZero();
    int count = 1;
    for (int d = 0; d < Dim; ++d) count *= points;
    for (int q = 0; q < count; ++q) {
      Vector xi;
      for (int d = 0, rest = q; d < Dim; ++d, rest /= points) xi(d) = -1 + (2 * (rest % points) + 1.0) / points;
      value += corner_function(c, xi) / count;
      for (int d = 0; d < Dim; ++d) {
        const Vector move = step * inverse.col(d);  // of xi, when x moves along direction d
        gradient(d) += (corner_function(c, xi + move) - corner_function(c, xi - move)) / (2 * step * count);
      }
    }
  }
};
using Dimensions = testing::Types<BasisCase<CpdiBasis, 2>, BasisCase<CpdiBasis, 3>>;
TYPED_TEST_SUITE(CpdiBasisTest, Dimensions, BasisCaseName);

TYPED_TEST(CpdiBasisTest, IsTheAverageOfTheCornerInterpolant) {
  constexpr int N = TypeParam::Dim;
  for (int k = 0; k < 40; ++k) {
    this->place_at_random();
    const auto w = this->weights();
    std::array<double, TestFixture::corners> share;
    std::array<typename TestFixture::Vector, TestFixture::corners> slope;
    double scale = 0;
    for (std::size_t c = 0; c < TestFixture::corners; ++c) {
      this->averages(c, share[c], slope[c]);
      scale = std::max(scale, slope[c].norm());
    }
    for (std::size_t i = 0; i < w.nodes(); ++i) {
      double value = 0;
      typename TestFixture::Vector gradient = TestFixture::Vector::Zero();
      for (std::size_t c = 0; c < TestFixture::corners; ++c) {
        const double hat = this->hat_at_corner(i, c);
        value += share[c] * hat;
        gradient += slope[c] * hat;
      }
      EXPECT_NEAR(w.node(i)[0], value, round_off);
      for (int d = 0; d < N; ++d) {
        EXPECT_NEAR(w.node(i)[1 + d], gradient(d), 1e-5 * scale);
      }
    }
  }
}

TYPED_TEST(CpdiBasisTest, FindsACornerOutsideTheGrid) {
  constexpr std::size_t N = TypeParam::Dim;
  this->F = {};
  for (std::size_t d = 0; d < N; ++d) this->F[d * N + d] = 1;
  EXPECT_TRUE(this->basis.place(0, this->x, this->F));
  this->F[1] = 1e3;  // shears the corners along the first direction
  EXPECT_FALSE(this->basis.place(0, this->x, this->F));
}

// A domain of its own, with half edges H, is the common one deformed beforehand: F H = (F H diag(half)^-1) diag(half).
TYPED_TEST(CpdiBasisTest, AParticlesOwnDomainIsTheCommonOneDeformedBeforehand) {
  constexpr std::size_t N = TypeParam::Dim;
  for (int k = 0; k < 40; ++k) {
    this->place_at_random();
    Mat<N> edges = random_deformation<TypeParam::Dim>(this->random), together{};
    for (double& entry : edges) entry *= 0.02;
    for (std::size_t i = 0; i < N; ++i) {
      for (std::size_t d = 0; d < N; ++d) {
        for (std::size_t j = 0; j < N; ++j) together[i * N + d] += this->F[i * N + j] * edges[j * N + d];
        together[i * N + d] /= this->half[d];
      }
    }
    const auto common = this->weights();
    ASSERT_TRUE(this->basis.place(0, this->x, this->F, edges));
    const auto own = this->weights();
    ASSERT_TRUE(this->basis.place(0, this->x, together));
    const auto deformed = this->weights();
    double change = 0;
    for (std::size_t i = 0; i < own.nodes(); ++i) {
      EXPECT_NEAR(own.node(i)[0], deformed.node(i)[0], round_off);
      for (std::size_t d = 0; d < N; ++d) {
        EXPECT_NEAR(own.node(i)[1 + d], deformed.node(i)[1 + d], 100 * round_off / this->grid.spacing);
        change = std::max(change, std::abs(own.node(i)[1 + d] - common.node(i)[1 + d]));
      }
    }
    EXPECT_GT(change, 1e-3);
  }
}

}  // namespace
}  // namespace assay::mpm::test_basis_cpdi
