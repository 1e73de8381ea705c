// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/judge.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace assay::check::test_judge {
namespace {

/// Errors at 100, 200 and 400 steps of increments under a rotation during load.
TEST(Limit, TellsAStepsErrorFromAModels) {
  const Limit green_naghdi = limit_of({4.3e-3, 1.1e-3, 2.7e-4}), hughes_winget = limit_of({2.1e-2, 1.0e-2, 5.1e-3});
  EXPECT_TRUE(green_naghdi.passes());
  EXPECT_NEAR(*green_naghdi.order, 2, 0.1);
  EXPECT_TRUE(hughes_winget.passes());
  EXPECT_NEAR(*hughes_winget.order, 1, 0.3);
  EXPECT_TRUE(limit_of({1e-13, 3e-13, 2e-13}).passes());
  EXPECT_FALSE(limit_of({.152, .151, .150}).passes());
  EXPECT_FALSE(limit_of({.153, .155, .156}).passes());
  EXPECT_FALSE(limit_of({.086, .086, .086}).passes());
}

TEST(Limit, TakesTheLargestOfAModelInSinglePrecisionAndNothingOfNaN) {
  EXPECT_EQ(limit_of({1e-7, 4e-7, 2e-7}).value, 4e-7);
  EXPECT_FALSE(limit_of({1e-7, 4e-7, 2e-7}).order);
  EXPECT_FALSE(limit_of({NAN, 0, 0}).passes());
}

TEST(Limit, SaysHowInOneSentence) {
  const auto say = [](std::array<double, 3> e) { return how(limit_of(e), e, 100); };
  EXPECT_EQ(say({0, 0, 0}), "exact for every step length");
  EXPECT_EQ(say({2.1e-2, 1.0e-2, 5.1e-3}), "converges with order 1.2 in the step: 0.021 at 100 steps, 0.0051 at 400");
  EXPECT_EQ(say({3e-7, 3e-7, 3e-7}), "to the model's own precision, 3e-07");
  EXPECT_EQ(say({.152, .151, .150}), "off by 0.15 of the largest stress, for every step length");
}

}  // namespace
}  // namespace assay::check::test_judge
