// SPDX-License-Identifier: BSD-3-Clause
// Twins: uGIMP where nothing is stretched; samples of the hat function over the stretched box; U by its definition.
#include <Eigen/Dense>

#include "tests/mpm/basis_cases.hpp"

namespace assay::mpm::test_basis_cpgimp {
namespace {

template <class Case>
struct CpgimpBasisTest : testing::Test, BasisFixture<Case> {
  static constexpr std::size_t Dim = Case::Dim;
};
using BothDimensions = testing::Types<BasisCase<CpgimpBasis, 2>, BasisCase<CpgimpBasis, 3>>;
TYPED_TEST_SUITE(CpgimpBasisTest, BothDimensions, BasisCaseName);

TYPED_TEST(CpgimpBasisTest, IsUgimpWhereNothingIsStretched) {
  constexpr int N = TypeParam::Dim;
  UgimpBasis<N> ugimp(this->grid, this->half, 1);
  for (int k = 0; k < 100; ++k) {
    this->x = this->random.template array<static_cast<std::size_t>(N)>(this->reach);
    Mat<N> turn{};  // by any angle about the third axis
    for (std::size_t d = 0; d < N; ++d) turn[d * N + d] = 1;
    const double angle = 3.2 * this->random();
    turn[0] = turn[N + 1] = std::cos(angle);
    turn[N] = std::sin(angle);
    turn[1] = -turn[N];
    ASSERT_TRUE(this->basis.place(0, this->x, turn));
    ASSERT_TRUE(ugimp.place(0, this->x, turn));
    GridField<1> a, b;
    a.allocate(this->grid.nodes());
    b.allocate(this->grid.nodes());
    this->basis.template scatter<1, 0>(0, {1}, {}, a.data());
    ugimp.template scatter<1, 0>(0, {1}, {}, b.data());
    for (std::size_t i = 0; i < a.nodes(); ++i) EXPECT_NEAR(a.node(i)[0], b.node(i)[0], round_off);
  }
}

TYPED_TEST(CpgimpBasisTest, BoxesStretchWithU) {
  constexpr std::size_t N = TypeParam::Dim;
  constexpr int samples = 4000;
  for (int k = 0; k < 10; ++k) {
    this->place_at_random();
    const Vec<N> stretch = stretches_along_axes(this->F);
    const auto w = this->weights();
    for (std::size_t d = 0; d < N; ++d) {  // the sum over the other directions is the weight along this one
      const double extent = std::min(this->half[d] * stretch[d], this->grid.spacing);
      std::map<std::int32_t, double> found, expected;
      for (std::size_t i = 0; i < w.nodes(); ++i) {
        std::size_t rest = i;
        for (std::size_t e = 0; e < d; ++e) rest /= static_cast<std::size_t>(this->grid.count[e]);
        found[static_cast<std::int32_t>(rest % static_cast<std::size_t>(this->grid.count[d]))] += w.node(i)[0];
      }
      for (int s = 0; s < samples; ++s) {
        const double at = this->x[d] + extent * ((2.0 * s + 1) / samples - 1);
        const double along = at / this->grid.spacing - this->grid.first[d];
        const auto cell = static_cast<std::int32_t>(along);
        expected[cell] += (1 - (along - cell)) / samples;
        expected[cell + 1] += (along - cell) / samples;
      }
      for (const auto& [node, value] : found) EXPECT_NEAR(value, expected[node], 1e-5);  // of the samples
    }
  }
}

TEST(CpgimpStretch, IsTheDiagonalOfTheRightStretch) {
  Random random(7);
  for (int k = 0; k < 50; ++k) {
    const Mat<3> F = random_deformation<3>(random);
    const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> gradient(F.data());
    const Eigen::Matrix3d C = gradient.transpose() * gradient;
    Eigen::Matrix3d U = Eigen::Matrix3d::Identity(), inverse = U;  // Denman and Beavers: C^(1/2)
    U = C;
    for (int iteration = 0; iteration < 60; ++iteration) {
      const Eigen::Matrix3d next = 0.5 * (U + inverse.inverse());
      inverse = 0.5 * (inverse + U.inverse()).eval();
      U = next;
    }
    const Vec<3> stretch = stretches_along_axes(F);
    for (int d = 0; d < 3; ++d) EXPECT_NEAR(stretch[static_cast<std::size_t>(d)], U(d, d), 1e-10 * U.norm());
  }
}

}  // namespace
}  // namespace assay::mpm::test_basis_cpgimp
