// SPDX-License-Identifier: BSD-3-Clause
#include "harness/numeric/stiff_integrator.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace assay::test_stiff_integrator {
namespace {

TEST(StiffIntegrator, FollowsASlowSolutionInFewSteps) {
  // x' = -1e6 (x - cos t) - sin t, x = cos t from x(0) = 1
  const RateFunction rate = [](const std::vector<double>& x, double t, std::vector<double>& slope) {
    slope[0] = -1e6 * (x[0] - std::cos(t)) - std::sin(t);
  };
  std::vector<double> x{1};
  double t = 0, step = 1e-3;
  const int steps = integrate_stiff(rate, x, t, 2.0, step, {1e-9, 1e-14, 0, 2});
  EXPECT_EQ(t, 2.0);
  EXPECT_GT(steps, 0);
  EXPECT_LT(steps, 1000);  // an explicit method needs a million
  EXPECT_NEAR(x[0], std::cos(2.0), 1e-7);
}

TEST(StiffIntegrator, SaysWhenTheStepBecomesTooShort) {
  const RateFunction rate = [](const std::vector<double>& x, double, std::vector<double>& slope) {
    slope[0] = x[0] * x[0];  // infinite at t = 1
  };
  std::vector<double> x{1};
  double t = 0, step = 1e-3;
  EXPECT_EQ(integrate_stiff(rate, x, t, 2.0, step, {1e-9, 1e-9, 0, 2}), -1);
  EXPECT_LT(t, 1.01);
}

}  // namespace
}  // namespace assay::test_stiff_integrator
