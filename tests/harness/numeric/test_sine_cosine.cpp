// SPDX-License-Identifier: BSD-3-Clause
#include "harness/numeric/sine_cosine.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <random>

namespace assay::test_sine_cosine {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// Against the library's of long double.
void expect_exact(double x) {
  double s = 0, c = 0;
  sine_cosine(x, s, c);
  EXPECT_NEAR(s, static_cast<double>(std::sin(static_cast<long double>(x))), epsilon) << x;
  EXPECT_NEAR(c, static_cast<double>(std::cos(static_cast<long double>(x))), epsilon) << x;
}

TEST(SineCosine, AreTheLibrarysOverAllQuarters) {
  std::mt19937_64 random(2026);
  for (const double reach : {1e-8, 1.0, 8.0, 300.0, largest_angle}) {
    std::uniform_real_distribution<double> angle(-reach, reach);
    for (int k = 0; k < 20000; ++k) expect_exact(angle(random));
  }
}

TEST(SineCosine, AreExactWhereQuartersMeet) {
  for (int k = -40; k <= 40; ++k) {
    const double edge = k * (std::numbers::pi / 4);
    for (const double x : {edge, std::nextafter(edge, 1e9), std::nextafter(edge, -1e9)}) expect_exact(x);
  }
  double s = 1, c = 0;
  sine_cosine(0, s, c);
  EXPECT_EQ(s, 0);
  EXPECT_EQ(c, 1);
}

TEST(SineCosine, SmallAnglesKeepTheirDigits) {
  for (const double x : {1e-300, 1e-20, 1e-9, 1e-4}) {
    double s = 0, c = 0;
    sine_cosine(x, s, c);
    EXPECT_NEAR(s, std::sin(x), 2 * epsilon * x);
  }
}

TEST(SineCosine, OfNoNumberIsNone) {
  double s = 0, c = 0;
  sine_cosine(std::numeric_limits<double>::quiet_NaN(), s, c);
  EXPECT_TRUE(std::isnan(s));
  EXPECT_TRUE(std::isnan(c));
}

}  // namespace
}  // namespace assay::test_sine_cosine
