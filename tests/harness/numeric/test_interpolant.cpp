// SPDX-License-Identifier: BSD-3-Clause
#include "harness/numeric/interpolant.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace assay::test_interpolant {
namespace {

Interpolant through(const std::vector<double>& x, const std::function<double(double)>& f,
                    Interpolation kind = Interpolation::spline) {
  std::vector<double> y;
  for (const double at : x) y.push_back(f(at));
  return {x, y, kind};
}

TEST(Interpolant, SplineReproducesPolynomialsUpToTheNumberOfItsPoints) {
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

TEST(Interpolant, SplineIsTwiceSmoothAcrossItsPointsAndConvergesAtFourthOrder) {
  const auto f = [](double x) { return std::sin(3 * x) + x * x; };
  double errors[2] = {};
  for (int level = 0; level < 2; ++level) {
    std::vector<double> x;
    const int n = 16 << level;
    for (int i = 0; i <= n; ++i) x.push_back(2.0 * i / n + (i % 2 && i < n ? 0.2 / n : 0));
    const Interpolant spline = through(x, f);
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

struct Rows {
  const char* name;
  std::vector<double> x, y;
};

/// Held after a rise, a triangle, a fall on unequal steps, two rows, held from the beginning and then a ramp.
const std::vector<Rows> tables{{"held", {0, 0.1, 0.2, 0.6, 1}, {0, 1.05, 1.05, 1.05, 1.05}},
                               {"triangle", {0, 0.2, 1}, {1, 1.01, 1}},
                               {"unequal", {0, 0.01, 0.4, 0.41, 3}, {0, -2, -2.1, -7, -7.001}},
                               {"two", {0, 0.3}, {1, 2}},
                               {"held, then a ramp", {0, 0.5, 0.6, 2}, {1, 1, 1, 3}}};

/// Of the interval that begins at x[i]: `looks` places in it, its ends too.
template <class Look>
void at_places(const Rows& rows, const Look& look) {
  constexpr int looks = 200;
  for (std::size_t i = 0; i + 1 < rows.x.size(); ++i) {
    for (int k = 0; k <= looks; ++k) look(i, rows.x[i] + (rows.x[i + 1] - rows.x[i]) * k / looks);
  }
}

TEST(Interpolant, LinearAndMonotoneStayBetweenNeighbours) {
  for (const Interpolation kind : {Interpolation::linear, Interpolation::monotone}) {
    for (const Rows& rows : tables) {
      const Interpolant f(rows.x, rows.y, kind);
      at_places(rows, [&](std::size_t i, double x) {
        const auto [lower, upper] = std::minmax(rows.y[i], rows.y[i + 1]);
        const double value = f.at(x).value;
        EXPECT_GE(value, lower - 1e-15 * std::abs(lower)) << rows.name << " at " << x;
        EXPECT_LE(value, upper + 1e-15 * std::abs(upper)) << rows.name << " at " << x;
        if (lower == upper) {
          EXPECT_EQ(value, lower) << rows.name << " at " << x;
        }
      });
      EXPECT_LT(f.farthest_departure().by, 1e-15) << rows.name;
    }
  }
}

TEST(Interpolant, TellsHowFarASplineSwings) {
  for (const Rows& rows : tables) {
    const Interpolant f(rows.x, rows.y, Interpolation::spline);
    double by = 0;
    at_places(rows, [&](std::size_t i, double x) {
      const auto [lower, upper] = std::minmax(rows.y[i], rows.y[i + 1]);
      by = std::max({by, f.at(x).value - upper, lower - f.at(x).value});
    });
    const Interpolant::Departure found = f.farthest_departure();
    EXPECT_NEAR(found.by, by, 1e-3 * by + 1e-15) << rows.name;
    EXPECT_EQ(found.by > 1e-12, std::string(rows.name) != "two") << rows.name;
    if (found.by > 1e-12) {
      EXPECT_DOUBLE_EQ(f.at(found.x).value, found.value) << rows.name;
    }
  }
}

/// By the formulas of PCHIM in exact fractions, as scipy.interpolate.PchipInterpolator has them: value, first and
/// second derivative.
TEST(Interpolant, MonotoneIsThatOfPchim) {
  const Interpolant f(std::vector{0.0, 0.5, 0.7, 1.6, 2.0, 3.0}, std::vector{1.0, 1.4, 2.0, 1.9, 1.9, 4.0},
                      Interpolation::monotone);
  const double expected[][4] = {{0.0, 1, 0, 4.091803278688524},
                                {0.2, 1.074701639344262, 0.711344262295082, 3.021639344262295},
                                {0.49, 1.386301219672131, 1.362617704918033, 1.469901639344262},
                                {0.6, 1.734426229508197, 4.155737704918033, -6.885245901639344},
                                {0.8, 1.996570644718793, -0.06584362139917696, -0.5761316872427984},
                                {1.3, 1.925925925925926, -0.1481481481481481, 0.2469135802469136},
                                {1.7, 1.9, 0, 0},
                                {2.5, 2.5, 2.25, 3.6},
                                {3.0, 4, 3.6, 1.8}};
  for (const auto& [x, value, slope, curvature] : expected) {
    EXPECT_NEAR(f.at(x).value, value, 1e-13) << x;
    EXPECT_NEAR(f.at(x).slope, slope, 1e-12) << x;
    EXPECT_NEAR(f.at(x).curvature, curvature, 1e-11) << x;
  }
}

TEST(Interpolant, DerivativesAreThoseOfTheValue) {
  constexpr double h = 1e-6;
  for (const Interpolation kind : {Interpolation::linear, Interpolation::monotone, Interpolation::spline}) {
    for (const Rows& rows : tables) {
      const Interpolant f(rows.x, rows.y, kind);
      for (std::size_t i = 0; i + 1 < rows.x.size(); ++i) {
        const double x = 0.7 * rows.x[i] + 0.3 * rows.x[i + 1], scale = 1 + std::abs(f.at(x).curvature);
        EXPECT_NEAR(f.at(x).slope, (f.at(x + h).value - f.at(x - h).value) / (2 * h), 1e-6 * scale) << rows.name;
        EXPECT_NEAR(f.at(x).curvature, (f.at(x + h).slope - f.at(x - h).slope) / (2 * h), 1e-6 * scale) << rows.name;
      }
    }
  }
}

/// At a point they are those behind it; the value is one of both sides.
TEST(Interpolant, DerivativesAtAPointAreThoseOfTheIntervalBehindIt) {
  for (const Interpolation kind : {Interpolation::linear, Interpolation::monotone}) {
    for (const Rows& rows : tables) {
      const Interpolant f(rows.x, rows.y, kind);
      for (std::size_t i = 0; i + 1 < rows.x.size(); ++i) {
        const double inside = rows.x[i] + 1e-9 * (rows.x[i + 1] - rows.x[i]);
        EXPECT_EQ(f.at(rows.x[i]).value, rows.y[i]) << rows.name;
        EXPECT_NEAR(f.at(rows.x[i]).slope, f.at(inside).slope, 1e-5) << rows.name;
        EXPECT_NEAR(f.at(rows.x[i]).curvature, f.at(inside).curvature, 1e-3) << rows.name;
      }
    }
  }
}

}  // namespace
}  // namespace assay::test_interpolant
