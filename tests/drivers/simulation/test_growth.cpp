// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/health.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace assay::drivers::test_growth {
namespace {

std::vector<ErrorSample> history_of(const std::function<double(double)>& error, int samples = 100) {
  std::vector<ErrorSample> history;
  for (int k = 0; k <= samples; ++k) {
    ErrorSample sample;
    sample.t = static_cast<double>(k) / samples;
    sample.displacement.l2 = error(sample.t);
    history.push_back(sample);
  }
  return history;
}

TEST(Growth, FindsTheRateAboveTheRounding) {
  for (const int samples : {50, 100, 1000}) {
    const auto found =
        growth_of(history_of([](double t) { return std::min(1e-2, 1e-15 * t + 1e-18 * std::exp(60 * t)); }, samples));
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->rate, 60, 8);
    EXPECT_GT(found->from, 0.03);
    EXPECT_LT(found->to, 0.75);
  }
}

TEST(Growth, RoundingThatAddsUpIsNone) {
  EXPECT_FALSE(growth_of(history_of([](double t) { return 1e-14 * t; })));
  EXPECT_FALSE(growth_of(history_of([](double t) { return 1e-6 * t * t; })));
  EXPECT_FALSE(growth_of(history_of([](double t) { return 1e-6 * std::sin(3 * t); })));
  EXPECT_FALSE(growth_of({}));
}

}  // namespace
}  // namespace assay::drivers::test_growth
