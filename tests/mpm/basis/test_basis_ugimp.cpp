// SPDX-License-Identifier: BSD-3-Clause
// Brute-force twin: the average of the hat function and of its gradient over the particle's box. The box is cut along
// the grid's planes; in each piece both are multilinear, so their value at the piece's centre is their exact average.
#include <algorithm>

#include "tests/mpm/basis_cases.hpp"

namespace assay::mpm::test_basis_ugimp {
namespace {

template <class Case>
struct UgimpBasisTest : testing::Test, BasisFixture<Case> {
  static constexpr std::size_t Dim = Case::Dim;

  /// Ends of the pieces of the box along one direction.
  std::vector<double> cuts(std::size_t d, const Vec<Dim>& half_size) const {
    std::vector<double> ends{this->x[d] - half_size[d], this->x[d] + half_size[d]};
    for (std::int32_t k = 0; k < this->grid.count[d]; ++k) {
      const double plane = this->grid.coordinate(static_cast<int>(d), k);
      if (plane > ends.front() && plane < this->x[d] + half_size[d]) ends.push_back(plane);
    }
    std::sort(ends.begin(), ends.end());
    return ends;
  }

  /// visit(share of the box, centre) for every piece.
  template <class Visitor>
  void pieces(const Vec<Dim>& half_size, const Visitor& visit) const {
    std::array<std::vector<double>, Dim> ends;
    std::size_t count = 1;
    for (std::size_t d = 0; d < Dim; ++d) ends[d] = cuts(d, half_size), count *= ends[d].size() - 1;
    for (std::size_t piece = 0; piece < count; ++piece) {
      std::size_t rest = piece;
      double share = 1;
      Vec<Dim> centre;
      for (std::size_t d = 0; d < Dim; ++d) {
        const std::size_t k = rest % (ends[d].size() - 1);
        rest /= ends[d].size() - 1;
        centre[d] = 0.5 * (ends[d][k] + ends[d][k + 1]);
        share *= (ends[d][k + 1] - ends[d][k]) / (2 * half_size[d]);
      }
      visit(share, centre);
    }
  }

  void expect_averages(const Vec<Dim>& half_size) const {
    const auto w = this->weights();
    for (std::size_t i = 0; i < w.nodes(); ++i) {
      double value = 0;
      Vec<Dim> gradient{};
      pieces(half_size, [&](double share, const Vec<Dim>& centre) {
        value += share * this->hat(i, centre);
        const auto slope = this->hat_gradient(i, centre);
        for (std::size_t d = 0; d < Dim; ++d) gradient[d] += share * slope[d];
      });
      EXPECT_NEAR(w.node(i)[0], value, round_off);
      for (std::size_t d = 0; d < Dim; ++d) EXPECT_NEAR(w.node(i)[1 + d], gradient[d], round_off / this->grid.spacing);
    }
  }
};
using Dimensions = testing::Types<BasisCase<UgimpBasis, 2>, BasisCase<UgimpBasis, 3>>;
TYPED_TEST_SUITE(UgimpBasisTest, Dimensions, BasisCaseName);

TYPED_TEST(UgimpBasisTest, IsTheAverageOfTheHatOverTheBox) {
  for (int k = 0; k < 40; ++k) {
    this->place_at_random();
    this->expect_averages(this->half);
  }
}

TYPED_TEST(UgimpBasisTest, IsTheSameOnNodesAndInTheMiddleOfCells) {
  for (const double at : {0.0, 0.05, 0.025, -0.1}) {
    this->x.fill(at);
    ASSERT_TRUE(this->basis.place(0, this->x, {}));
    this->expect_averages(this->half);
  }
}

TYPED_TEST(UgimpBasisTest, IsTheAverageOverAParticlesOwnBox) {
  for (int k = 0; k < 40; ++k) {
    this->place_at_random();
    Vec<TypeParam::Dim> own;
    for (double& extent : own) extent = 0.5 * this->grid.spacing * (0.05 + 0.45 * (1 + this->random()));
    ASSERT_TRUE(this->basis.place(0, this->x, this->F, own));
    this->expect_averages(own);
  }
}

}  // namespace
}  // namespace assay::mpm::test_basis_ugimp
