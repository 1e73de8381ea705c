// SPDX-License-Identifier: BSD-3-Clause
#include "harness/numeric/chebyshev.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace assay::chebyshev::test_chebyshev {
namespace {

constexpr double round_off = 1e-13;
const Interval interval{-0.7, 2.3};

double polynomial(double x) { return 3 + x - 2 * x * x + 0.25 * std::pow(x, 5); }
double slope(double x) { return 1 - 4 * x + 1.25 * std::pow(x, 4); }

TEST(Chebyshev, NodesAscendFromEndToEnd) {
  for (const int n : {2, 3, 9, 64}) {
    const auto x = nodes(interval, n);
    EXPECT_EQ(x.front(), interval.lower);
    EXPECT_EQ(x.back(), interval.upper);
    EXPECT_TRUE(std::is_sorted(x.begin(), x.end()));
  }
}

TEST(Chebyshev, ReproducesPolynomialsAndTheirSlopes) {
  const int n = 8;
  std::vector<double> values, T(n), T_prime(n);
  for (const double x : nodes(interval, n)) values.push_back(polynomial(x));
  const auto c = coefficients(values);
  for (const double x : {-0.7, -0.1, 0.9, 2.2999, 2.3}) {
    basis(2 * (x - interval.lower) / interval.width() - 1, T, T_prime);
    double value = 0, derivative = 0;
    for (std::size_t k = 0; k < T.size(); ++k) {
      value += c[k] * T[k];
      derivative += c[k] * T_prime[k] * 2 / interval.width();
    }
    EXPECT_NEAR(value, polynomial(x), 100 * round_off);
    EXPECT_NEAR(derivative, slope(x), 1000 * round_off);
  }
}

TEST(Chebyshev, TransformsLinesOfAnyStrideInPlace) {
  const int n = 8;
  std::vector<double> values(3 * n, -1), T(n), T_prime(n);
  const auto s = gauss_nodes(n);
  for (std::size_t k = 0; k < s.size(); ++k) values[3 * k + 1] = polynomial(s[k]);
  GaussTransform transform(n);
  transform(&values[1], 3);
  for (const double at : {0.0, 0.3, 0.77, 1.0}) {
    basis(2 * at - 1, T, T_prime);
    double value = 0;
    for (std::size_t k = 0; k < T.size(); ++k) value += values[3 * k + 1] * T[k];
    EXPECT_NEAR(value, polynomial(at), 100 * round_off);
  }
  for (std::size_t k = 0; k < s.size(); ++k) EXPECT_EQ(values[3 * k], -1);
}

}  // namespace
}  // namespace assay::chebyshev::test_chebyshev
