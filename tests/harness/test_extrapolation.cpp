// SPDX-License-Identifier: BSD-3-Clause
#include "harness/extrapolation.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace assay {
namespace {

/// y' = -y over a step of length 1/4 by `count` sub-steps: first order (backward Euler) or second (trapezoidal,
/// symmetric).
double substeps(int count, bool symmetric) {
  double y = 1;
  const double h = 0.25 / count;
  for (int k = 0; k < count; ++k) y *= symmetric ? (1 - 0.5 * h) / (1 + 0.5 * h) : 1 / (1 + h);
  return y;
}

TEST(Extrapolation, RemovesPowersOfTheStepOneByOne) {
  for (const bool symmetric : {false, true}) {
    Extrapolation table;
    table.clear();
    double before = 1;
    for (int count = 1; count <= Extrapolation::most_columns; ++count) {
      const double result[] = {substeps(count, symmetric)}, scale[] = {1};
      table.add(result, scale);
      const double error = std::abs(table.best()[0] - std::exp(-0.25));
      if (count > 1) {
        EXPECT_LT(error, 0.6 * before + table.rounding()) << symmetric << count;
        EXPECT_LE(error, table.error() + table.rounding()) << "the estimate is a bound for smooth results";
      }
      before = error;
    }
    EXPECT_LT(before, symmetric ? 1e-13 : 1e-8);
    EXPECT_EQ(table.columns(), Extrapolation::most_columns);
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
}  // namespace assay
