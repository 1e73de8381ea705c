// SPDX-License-Identifier: BSD-3-Clause
// Against the plain hat function at every node of the grid.
#include "tests/mpm/basis_cases.hpp"

namespace assay::mpm::test_basis_linear {
namespace {

template <class Case>
struct LinearBasisTest : testing::Test, BasisFixture<Case> {};
using Dimensions = testing::Types<BasisCase<LinearBasis, 2>, BasisCase<LinearBasis, 3>>;
TYPED_TEST_SUITE(LinearBasisTest, Dimensions, BasisCaseName);

TYPED_TEST(LinearBasisTest, IsTheHatFunction) {
  for (int k = 0; k < 100; ++k) {
    this->place_at_random();
    const auto w = this->weights();
    for (std::size_t i = 0; i < w.nodes(); ++i) {
      EXPECT_NEAR(w.node(i)[0], this->hat(i, this->x), round_off);
      const auto gradient = this->hat_gradient(i, this->x);
      for (std::size_t d = 0; d < TypeParam::Dim; ++d) {
        EXPECT_NEAR(w.node(i)[1 + d], gradient[d], round_off / this->grid.spacing);
      }
    }
  }
}

}  // namespace
}  // namespace assay::mpm::test_basis_linear
