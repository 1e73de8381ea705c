// SPDX-License-Identifier: BSD-3-Clause
#include "harness/cubic_spline.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace assay::test_cubic_spline {
namespace {

CubicSpline through(const std::vector<double>& x, const std::function<double(double)>& f) {
  std::vector<double> y;
  for (const double at : x) y.push_back(f(at));
  return {x, y};
}

TEST(CubicSpline, ReproducesPolynomialsUpToTheNumberOfItsPoints) {
  const auto cubic = [](double x) { return 1 + x * (2 + x * (-3 + 0.5 * x)); };
  const auto parabola = [](double x) { return 1 + x * (2 - 3 * x); };
  const auto line = [](double x) { return 1 + 2 * x; };
  const std::vector<double> x{0, 0.3, 0.4, 1.1, 2};
  for (const double at : {-0.2, 0.0, 0.1, 0.3, 0.9, 2.0, 2.3}) {
    for (const std::size_t n : {4u, 5u}) {
      const auto value = through({x.begin(), x.begin() + static_cast<long>(n)}, cubic).at(at);
      EXPECT_NEAR(value.value, cubic(at), 1e-12) << n;
      EXPECT_NEAR(value.slope, 2 - 6 * at + 1.5 * at * at, 1e-12) << n;
      EXPECT_NEAR(value.curvature, -6 + 3 * at, 1e-11) << n;
    }
    EXPECT_NEAR(through({0, 0.3, 1.1}, parabola).at(at).value, parabola(at), 1e-13);
    EXPECT_NEAR(through({0, 0.3}, line).at(at).value, line(at), 1e-13);
  }
}

TEST(CubicSpline, IsTwiceSmoothAcrossItsPointsAndConvergesAtFourthOrder) {
  const auto f = [](double x) { return std::sin(3 * x) + x * x; };
  double errors[2] = {};
  for (int level = 0; level < 2; ++level) {
    std::vector<double> x;
    const int n = 16 << level;
    for (int i = 0; i <= n; ++i) x.push_back(2.0 * i / n + (i % 2 && i < n ? 0.2 / n : 0));
    const CubicSpline spline = through(x, f);
    for (std::size_t i = 1; i + 1 < x.size(); ++i) {
      const auto before = spline.at(x[i] - 1e-9), behind = spline.at(x[i] + 1e-9);
      EXPECT_NEAR(before.slope, behind.slope, 1e-7);
      EXPECT_NEAR(before.curvature, behind.curvature, 1e-6);
    }
    for (int i = 0; i < 500; ++i)
      errors[level] = std::max(errors[level], std::abs(spline.at(i * 4e-3).value - f(i * 4e-3)));
  }
  EXPECT_NEAR(std::log2(errors[0] / errors[1]), 4, 0.7);
}

}  // namespace
}  // namespace assay::test_cubic_spline
