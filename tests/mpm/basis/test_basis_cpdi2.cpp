// SPDX-License-Identifier: BSD-3-Clause
// Brute-force twin: the corner functions Q_c and their gradients averaged over a domain of arbitrary corners by a fine
// quadrature with the Jacobian of the map, written without the closed forms.
#include <Eigen/LU>

#include "tests/mpm/basis_cases.hpp"

namespace assay::mpm::test_basis_cpdi2 {
namespace {

constexpr int points = 5;  ///< of Gauss, in each direction: exact to degree 9
constexpr std::array<double, points> abscissas{-0.90617984593866399, -0.53846931010568309, 0, 0.53846931010568309,
                                               0.90617984593866399};
constexpr std::array<double, points> shares{0.23692688505618909, 0.47862867049936647, 0.56888888888888889,
                                            0.47862867049936647, 0.23692688505618909};

template <class Case>
struct Cpdi2BasisTest : testing::Test, BasisFixture<Case> {
  static constexpr int Dim = Case::Dim;
  static constexpr std::size_t corners = 1 << Dim;
  using Vector = Eigen::Matrix<double, Dim, 1>;
  using Matrix = Eigen::Matrix<double, Dim, Dim>;

  Corners<Dim> at{};

  /// A deformed box, each corner moved by up to a fifth of its half edges besides.
  void place_irregularly() {
    this->place_at_random();
    Mat<Dim> r;
    for (std::size_t k = 0; k < Dim * Dim; ++k) r[k] = this->F[k] * this->half[k % Dim];
    at = corners_of<Dim>(this->x, r);
    for (auto& corner : at) {
      for (std::size_t d = 0; d < Dim; ++d) {
        const double own = this->random();
        for (std::size_t i = 0; i < Dim; ++i) corner[i] += 0.2 * own * r[i * Dim + d];
      }
    }
    ASSERT_TRUE(this->basis.place(0, at));
  }

  static double corner_function(std::size_t c, const Vector& xi) {
    double product = 1;
    for (int d = 0; d < Dim; ++d) product *= 0.5 * (1 + (c >> d & 1 ? 1 : -1) * xi(d));
    return product;
  }
  Vector map(const Vector& xi) const {
    Vector x = Vector::Zero();
    for (std::size_t c = 0; c < corners; ++c) {
      for (int i = 0; i < Dim; ++i) x(i) += corner_function(c, xi) * at[c][static_cast<std::size_t>(i)];
    }
    return x;
  }

  /// Differences of multilinear functions along one direction are exact.
  static Vector slope(std::size_t c, const Vector& xi) {
    Vector found;
    for (int d = 0; d < Dim; ++d) {
      Vector before = xi, after = xi;
      before(d) = -1, after(d) = 1;
      found(d) = 0.5 * (corner_function(c, after) - corner_function(c, before));
    }
    return found;
  }

  /// Q_c and its gradient averaged over the domain; the domain's volume.
  double averages(std::size_t c, double& value, Vector& gradient) const {
    double volume = 0;
    value = 0;
    gradient.setZero();
    int count = 1;
    for (int d = 0; d < Dim; ++d) count *= points;
    for (int q = 0; q < count; ++q) {
      Vector xi;
      double share = 1;
      for (int d = 0, rest = q; d < Dim; ++d, rest /= points) {
        xi(d) = abscissas[static_cast<std::size_t>(rest % points)];
        share *= shares[static_cast<std::size_t>(rest % points)];
      }
      Matrix J = Matrix::Zero();
      for (std::size_t k = 0; k < corners; ++k) {
        for (int i = 0; i < Dim; ++i) J.row(i) += at[k][static_cast<std::size_t>(i)] * slope(k, xi).transpose();
      }
      const double weight = share * J.determinant();
      volume += weight;
      value += weight * corner_function(c, xi);
      gradient += weight * (J.inverse().transpose() * slope(c, xi));
    }
    value /= volume;
    gradient /= volume;
    return volume;
  }
};
using Cpdi2Dimensions = testing::Types<BasisCase<Cpdi2Basis, 2>, BasisCase<Cpdi2Basis, 3>>;
TYPED_TEST_SUITE(Cpdi2BasisTest, Cpdi2Dimensions, BasisCaseName);

TYPED_TEST(Cpdi2BasisTest, IsTheAverageOfTheCornerInterpolant) {
  constexpr int N = TypeParam::Dim;
  for (int k = 0; k < 40; ++k) {
    this->place_irregularly();
    const auto w = this->weights();
    std::vector<std::array<double, 1 + N>> expected(w.nodes());
    double scale = 0;
    for (std::size_t c = 0; c < TestFixture::corners; ++c) {
      double share = 0;
      typename TestFixture::Vector slope;
      const double volume = this->averages(c, share, slope);
      EXPECT_NEAR(average_over(this->at).volume, volume, 1e-12 * volume);
      scale = std::max(scale, slope.norm());
      for (std::size_t i = 0; i < w.nodes(); ++i) {
        const double hat = this->hat(i, this->at[c]);
        expected[i][0] += share * hat;
        for (int d = 0; d < N; ++d) expected[i][static_cast<std::size_t>(1 + d)] += slope(d) * hat;
      }
    }
    for (std::size_t i = 0; i < w.nodes(); ++i) {
      EXPECT_NEAR(w.node(i)[0], expected[i][0], round_off);
      for (std::size_t d = 0; d < N; ++d) EXPECT_NEAR(w.node(i)[1 + d], expected[i][1 + d], round_off * scale);
    }
  }
}

// A parallelepiped's corners count alike: there it is CPDI.
TYPED_TEST(Cpdi2BasisTest, IsCpdiWhereTheDomainIsAParallelepiped) {
  constexpr std::size_t N = TypeParam::Dim;
  CpdiBasis<TypeParam::Dim> other(this->grid, this->half, 1);
  for (int k = 0; k < 40; ++k) {
    this->place_at_random();
    ASSERT_TRUE(other.place(0, this->x, this->F));
    const auto own = this->weights();
    GridField<N + 1> theirs;
    theirs.allocate(this->grid.nodes());
    Mat<N> identity{};
    for (std::size_t d = 0; d < N; ++d) identity[d * N + d] = 1;
    other.template scatter<N + 1, N>(0, {1}, identity, theirs.data());
    for (std::size_t i = 0; i < own.nodes(); ++i) {
      EXPECT_NEAR(own.node(i)[0], theirs.node(i)[0], round_off);
      for (std::size_t d = 1; d <= N; ++d) EXPECT_NEAR(own.node(i)[d], theirs.node(i)[d], 100 * round_off / 0.1);
    }
  }
}

TYPED_TEST(Cpdi2BasisTest, FindsADomainOutsideTheGridAndOneInsideOut) {
  this->place_irregularly();
  Corners<TypeParam::Dim> away = this->at, inverted = this->at;
  away[1][0] += 1e3;
  EXPECT_FALSE(this->basis.place(0, away));
  for (std::size_t c = 0; c < inverted.size(); c += 2) std::swap(inverted[c], inverted[c + 1]);
  EXPECT_FALSE(this->basis.place(0, inverted));
}

}  // namespace
}  // namespace assay::mpm::test_basis_cpdi2
