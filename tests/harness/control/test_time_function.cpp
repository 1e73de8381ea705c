// SPDX-License-Identifier: BSD-3-Clause
#include "harness/control/time_function.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace assay::test_time_function {
namespace {

using Times = std::vector<double>;

TEST(TimeFunction, RampsAndHolds) {
  const TimeFunction f = TimeFunction::ramp(1, 3, 0.5, 1.5);
  EXPECT_EQ(f.at(0), 1);
  EXPECT_EQ(f.at(1), 2);
  EXPECT_EQ(f.at(1.5), 3);
  EXPECT_EQ(f.at(9), 3);
  EXPECT_EQ(f.knots(2), (Times{0.5, 1.5}));
}

/// A table whose value is held stays there: nothing overshoots.
TEST(TimeFunction, KeepsHeldRows) {
  const Times t{0, 1, 2, 3}, v{1, 1.05, 1.05, 1.05};
  const TimeFunction f = TimeFunction::table(t, v, Interpolation::linear);
  for (double x = 1; x <= 3; x += 0.01) EXPECT_EQ(f.at(x), 1.05) << x;
  EXPECT_EQ(f.knots(3), (Times{1, 2}));
  EXPECT_FALSE(f.farthest_departure());
  const TimeFunction spline = TimeFunction::table(t, v, Interpolation::spline);
  ASSERT_TRUE(spline.farthest_departure());
  EXPECT_GT(spline.farthest_departure()->by, 1e-3);
  EXPECT_FALSE(TimeFunction::table(t, v, Interpolation::monotone).farthest_departure());
}

TEST(TimeFunction, JumpsWhereTwoRowsHaveOneTime) {
  const Times t{0, 1, 1, 2}, v{0, 1, 5, 5};
  const TimeFunction f = TimeFunction::table(t, v, Interpolation::linear);
  EXPECT_EQ(f.at(1, false), 1);
  EXPECT_EQ(f.at(1, true), 5);
  EXPECT_EQ(f.at(0.5), 0.5);
  EXPECT_EQ(f.at(1.5), 5);
  EXPECT_EQ(f.knots(2), Times{1});
}

TEST(TimeFunction, CyclesGrow) {
  const TimeFunction f = TimeFunction::cycles(Times{1, 2}, 4, true);
  EXPECT_EQ(f.at(1), 1);
  EXPECT_EQ(f.at(3), -1);
  EXPECT_EQ(f.at(4), 0);
  EXPECT_EQ(f.at(5), 2);
  EXPECT_EQ(f.at(7), -2);
  EXPECT_EQ(f.at(8), 0);
  EXPECT_EQ(f.at(9), 0);
  EXPECT_EQ(TimeFunction::sine(0, 1, 4, 0).knots(4.5), (Times{1, 2, 3, 4}));
  EXPECT_EQ(TimeFunction::sine(0, 1, 4, std::numbers::pi / 4).knots(3), (Times{0.5, 1.5, 2.5}));
  const TimeFunction smooth = TimeFunction::cycles(Times{3}, 2, false);
  EXPECT_DOUBLE_EQ(smooth.at(0.5), 3);
}

/// Integrals against sums of many small pieces.
TEST(TimeFunction, IntegratesExactly) {
  const Times t{0, 0.3, 1, 1, 1.6}, v{1, -2, 0.5, 4, 1};
  const Times sizes{1, 2};
  for (const TimeFunction& f :
       {TimeFunction::constant(2), TimeFunction::ramp(1, 3, 0.5, 1.5), TimeFunction::sine(0.3, 2, 0.7, 0.4),
        TimeFunction::table(t, v, Interpolation::linear), TimeFunction::table(t, v, Interpolation::spline),
        TimeFunction::table(t, v, Interpolation::monotone), TimeFunction::cycles(sizes, 0.9, true),
        TimeFunction::cycles(sizes, 0.9, false).scaled(-2, 0.5)}) {
    for (const double end : {0.2, 1.0, 1.9}) {
      double sum = 0;
      constexpr int pieces = 200'000;
      for (int k = 0; k < pieces; ++k) sum += f.at((k + 0.5) / pieces * end) * end / pieces;
      EXPECT_NEAR(f.integral(end), sum, 1e-5);  // of the midpoint rule at a jump
    }
  }
}

}  // namespace
}  // namespace assay::test_time_function
