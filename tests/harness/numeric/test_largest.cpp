// SPDX-License-Identifier: BSD-3-Clause
#include "harness/numeric/norms.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "harness/check/march.hpp"
#include "harness/exact/response.hpp"
#include "tests/harness/check/mutants.hpp"

namespace assay::test_largest {
namespace {

TEST(Largest, IsNoNumberWhereOneIsNone) {
  EXPECT_EQ(larger(1, 2), 2);
  EXPECT_EQ(larger(2, 1), 2);
  EXPECT_EQ(larger(-INFINITY, 1), 1);
  for (const double number : {0.0, 1.0, double{INFINITY}}) {
    EXPECT_TRUE(std::isnan(larger(NAN, number)));
    EXPECT_TRUE(std::isnan(larger(number, NAN)));
  }
  for (int c = 0; c < 9; ++c) {
    Tensor A = Tensor::Identity();
    EXPECT_EQ(largest_of(-3 * A), 3);
    component(A, c) = NAN;
    EXPECT_TRUE(std::isnan(largest_of(A))) << c;
    EXPECT_TRUE(std::isnan(check::distance(A, Tensor::Zero()))) << c;
  }
}

/// As a rate form is, a closed form that is no number is a failure of the material.
TEST(Largest, AClosedFormOfNoNumberIsAFailure) {
  Path path;
  path.name = "uniaxial_strain";
  path.amplitude = [](double t) { return t; };
  int failures = 0;
  for (const check_tests::Subject& subject : check_tests::extension_mutants::subjects()) {
    const auto form = ClosedForm::of(std::shared_ptr<const Material>(std::shared_ptr<void>(), &subject.material), path);
    if (!form) continue;
    Tensor tau, slope;
    const bool no_number = subject.name.ends_with("of_no_number");
    failures += no_number;
    if (no_number)
      EXPECT_THROW(form->at(0.1, 1, tau, slope), MaterialFailure) << subject.name;
    else
      EXPECT_NO_THROW(form->at(0.1, 1, tau, slope)) << subject.name;
  }
  EXPECT_EQ(failures, 2);
}

}  // namespace
}  // namespace assay::test_largest
