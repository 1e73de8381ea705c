// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/models/vector_log.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace assay::test_vector_log {
namespace {

/// Within one unit in the last place of the library's of long double.
void expect_exact(double x) {
  const auto exact = static_cast<double>(std::log(static_cast<long double>(x)));
  const double unit = std::nextafter(std::abs(exact), HUGE_VAL) - std::abs(exact);
  EXPECT_NEAR(vector_log(x), exact, unit) << x;
}

TEST(VectorLog, IsTheLibrarysOverAllMagnitudes) {
  std::mt19937_64 random(2026);
  std::uniform_real_distribution<double> exponent(-1020, 1020), near(-1, 1);
  for (int k = 0; k < 20000; ++k) {
    expect_exact(std::exp2(exponent(random)));
    expect_exact(1 + 0.5 * near(random));
    expect_exact(1 + 1e-9 * near(random));
  }
}

TEST(VectorLog, OfOneIsZeroAndOfPowersOfTwoExact) {
  EXPECT_EQ(vector_log(1), 0);
  for (int k = -1000; k <= 1000; k += 7) expect_exact(std::ldexp(1.0, k));
  for (const double edge : {std::sqrt(0.5), std::sqrt(2.0)}) {
    for (const double x : {edge, std::nextafter(edge, 0), std::nextafter(edge, 2)}) expect_exact(x);
  }
  expect_exact(std::numeric_limits<double>::min());
  expect_exact(std::numeric_limits<double>::max());
}

}  // namespace
}  // namespace assay::test_vector_log
