// SPDX-License-Identifier: BSD-3-Clause
#include "harness/numeric/extrapolation.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace assay::test_extrapolation {
namespace {

/// Increments of y' = -y, by what they err: h, h^2, h^3 ... (backward Euler); h^2, h^3, h^4 ... (explicit midpoint);
/// h^2, h^4, h^6 ... (trapezoidal, symmetric in time).
enum class Rule { backward_euler, midpoint, trapezoidal };
constexpr Rule rules[] = {Rule::backward_euler, Rule::midpoint, Rule::trapezoidal};

/// Over a step of length 1/4 by `count` sub-steps.
double substeps(int count, Rule rule) {
  double y = 1;
  const double h = 0.25 / count;
  for (int k = 0; k < count; ++k) {
    y *= rule == Rule::trapezoidal ? (1 - 0.5 * h) / (1 + 0.5 * h)
         : rule == Rule::midpoint  ? 1 - h + 0.5 * h * h
                                   : 1 / (1 + h);
  }
  return y;
}

TEST(Extrapolation, RemovesPowersOfTheStepOneByOne) {
  for (const Rule rule : rules) {
    Extrapolation table;
    table.clear();
    double before = 1;
    for (int count = 1; count <= Extrapolation::most_columns; ++count) {
      const double result[] = {substeps(count, rule)}, scale[] = {1};
      table.add(result, scale);
      const double error = std::abs(table.best()[0] - std::exp(-0.25));
      if (count > 1) {
        EXPECT_LT(error, 0.6 * before + table.rounding()) << static_cast<int>(rule) << count;
        EXPECT_LE(error, table.error() + table.rounding()) << "the estimate is a bound for smooth results";
      }
      before = error;
    }
    EXPECT_LT(before, rule == Rule::trapezoidal ? 1e-13 : rule == Rule::midpoint ? 1e-9 : 1e-8);
    EXPECT_EQ(table.columns(), Extrapolation::most_columns);
  }
}

/// A symmetric increment but for a small error in h^3: the series of even powers leaves it, and must not hide it. A
/// factor of three, for two powers that are left may oppose each other in the estimate.
TEST(Extrapolation, StatesAnOddPowerThatTheEvenOnesLeave) {
  for (const double odd : {1e-3, 1e-5, 1e-7}) {
    Extrapolation table;
    table.clear();
    for (int count = 1; count <= Extrapolation::most_columns; ++count) {
      const double result[] = {substeps(count, Rule::trapezoidal) + odd / (count * count * count)}, scale[] = {1};
      table.add(result, scale);
      if (count < 3) continue;
      const double error = std::abs(table.best()[0] - std::exp(-0.25));
      EXPECT_LE(error, 3 * table.error() + table.rounding()) << odd << " " << count;
    }
  }
}

TEST(Extrapolation, DoesNotTrustResultsWithoutAnExpansion) {
  Extrapolation table;
  table.clear();
  const double scale[] = {1};
  for (int count = 1; count <= 6; ++count) {  // a kink: errors jump about
    const double result[] = {1 + (count % 3) * 0.1 / count};
    table.add(result, scale);
  }
  EXPECT_GT(table.error(), 1e-3);
}

TEST(Extrapolation, KnowsHowItEnlargesRounding) {
  Extrapolation table;
  table.clear();
  const double result[] = {1}, scale[] = {1};
  for (int count = 1; count <= Extrapolation::most_columns; ++count) table.add(result, scale);
  EXPECT_EQ(table.best()[0], 1);
  EXPECT_GT(table.rounding(), 2e-16);
  EXPECT_LT(table.rounding(), 1e-12);
}

}  // namespace
}  // namespace assay::test_extrapolation
