// SPDX-License-Identifier: BSD-3-Clause
#include "harness/numeric/convergence.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace assay::test_convergence {
namespace {

using Sequence = std::vector<double>;

const Sequence halved{0.2, 0.1, 0.05, 0.025};

template <class Error>
Sequence errors_on(const Sequence& h, const Error& error) {
  Sequence errors;
  for (const double each : h) errors.push_back(error(each));
  return errors;
}

TEST(Convergence, FitsAPowerLaw) {
  for (const double order : {0.5, 1.0, 2.0, 4.0, -1.0}) {
    const auto fit = fitted_order(halved, errors_on(halved, [&](double h) { return 3 * std::pow(h, order); }));
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->order, order, 1e-12);
    EXPECT_NEAR(*fit->lower, order, 1e-6);
    EXPECT_NEAR(*fit->upper, order, 1e-6);
  }
}

// Slope 2.1, residuals of log2(error) .1, -.2, .1: s^2 = .06, Sxx = 2, t(0.975, 1) = 12.706.
TEST(Convergence, IntervalIsStudents) {
  const auto fit = fitted_order({4, 2, 1}, {std::exp2(4.2), std::exp2(1.8), 1});
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->order, 2.1, 1e-12);
  EXPECT_NEAR(*fit->upper - fit->order, 12.706 * std::sqrt(0.06 / 2), 1e-3);
  EXPECT_NEAR(fit->order - *fit->lower, 12.706 * std::sqrt(0.06 / 2), 1e-3);
}

TEST(Convergence, TwoResolutionsHaveNoInterval) {
  const auto fit = fitted_order({0.1, 0.05}, {0.04, 0.01});
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->order, 2, 1e-12);
  EXPECT_FALSE(fit->lower || fit->upper);
}

TEST(Convergence, NoFitWithoutLogarithms) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(fitted_order({}, {}));
  EXPECT_FALSE(fitted_order({0.1}, {0.1}));
  EXPECT_FALSE(fitted_order({0.1, 0.1, 0.1}, {0.1, 0.2, 0.3}));
  EXPECT_FALSE(fitted_order({0.1, 0.05}, {0.1}));
  for (const double bad : {0.0, -1.0, nan, inf}) {
    EXPECT_FALSE(fitted_order({0.2, 0.1}, {0.1, bad})) << bad;
    EXPECT_FALSE(fitted_order({0.2, bad}, {0.1, 0.2})) << bad;
  }
}

TEST(Convergence, OrdersFromTheResolutionBefore) {
  const auto orders = pairwise_orders({0.2, 0.1, 0.1, 0.05, 0.025}, {0.04, 0.01, 0.01, 0, 0.1});
  ASSERT_EQ(orders.size(), 5u);
  EXPECT_FALSE(orders[0]);
  EXPECT_NEAR(*orders[1], 2, 1e-12);
  for (const std::size_t i : {2u, 3u, 4u}) EXPECT_FALSE(orders[i]) << i;
}

/// 0.3 / 3 is not 0.1.
TEST(Convergence, EqualResolutionsHaveNoOrder) {
  const double same = 0.3 / 3;
  EXPECT_FALSE(fitted_order({0.1, same}, {1, 0.5}));
  EXPECT_FALSE(pairwise_orders({0.1, same}, {1, 0.5})[1]);
  EXPECT_FALSE(pairwise_orders({0.1, 0.1 * (1 + 1e-9)}, {1, 0.5})[1]);
  EXPECT_TRUE(pairwise_orders({0.1, 0.099}, {1, 0.99})[1]);
  for (const Sequence& h : {Sequence{0.2, 0.1, same}, Sequence{0.1, same, 0.05}}) {
    const RangeJudgement found = asymptotic_range(h, {1, 0.5, 0.2});
    EXPECT_EQ(found.range, AsymptoticRange::unknown);
    EXPECT_NE(found.sentence.find("of one resolution"), std::string::npos) << found.sentence;
  }
}

// Of 4000 fits to noisy second order 95 % have 2 in their interval: the count's standard deviation is 0.34 %.
TEST(Convergence, IntervalCoversNinetyFivePercent) {
  for (const std::size_t n : {3u, 4u, 6u}) {
    std::mt19937_64 random(n);
    std::normal_distribution<double> noise(0, 0.05);
    Sequence h;
    for (std::size_t i = 0; i < n; ++i) h.push_back(std::exp2(-static_cast<double>(i)));
    int covered = 0;
    constexpr int fits = 4000;
    for (int k = 0; k < fits; ++k) {
      const auto fit =
          fitted_order(h, errors_on(h, [&](double each) { return each * each * std::exp(noise(random)); }));
      if (fit && *fit->lower <= 2 && 2 <= *fit->upper) ++covered;
    }
    EXPECT_NEAR(covered / double(fits), 0.95, 4 * 0.0034) << n;
  }
}

TEST(Convergence, RangeIsReachedWhereTheNextTermIsSmall) {
  for (const double order : {0.5, 1.0, 2.0, 4.0}) {
    const auto found =
        asymptotic_range(halved, errors_on(halved, [&](double h) { return std::pow(h, order) * (1 + 2 * h); }));
    EXPECT_EQ(found.range, AsymptoticRange::reached) << order << found.sentence;
  }
  const auto judged = asymptotic_range({0.1, 0.05, 0.025}, {4e-2, 1e-2, 2.5e-3});
  EXPECT_EQ(judged.sentence, "reached: orders 2.00 and 2.00 on the three finest differ by 0.00, at most 0.1");
}

// The tolerance is what its comment says.
TEST(Convergence, TheToleranceIsDerived) {
  const auto orders = [](double a) {
    const Sequence h{4, 2, 1};
    return pairwise_orders(h, errors_on(h, [&](double each) { return each * each * (1 + a * each); }));
  };
  double most = 0;
  for (double a = 1e-3; a < 1e3; a *= 1.02) most = std::max(most, *orders(a)[1] - *orders(a)[2]);
  EXPECT_NEAR(most, 0.17, 0.005);
  EXPECT_NEAR(*orders(0.104)[1] - *orders(0.104)[2], order_tolerance, 0.002);
  EXPECT_NEAR(*orders(0.104)[2] - 2, 0.13, 0.005);
}

TEST(Convergence, BeforeTheRangeItIsNotReached) {
  const auto range = [](const auto& error) { return asymptotic_range(halved, errors_on(halved, error)); };
  const auto next = range([](double h) { return h * h + 10 * h * h * h; });
  EXPECT_EQ(next.range, AsymptoticRange::not_reached) << next.sentence;
  const auto coarse = range([](double h) { return h * h + 400 * h * h * h * h; });
  EXPECT_EQ(coarse.range, AsymptoticRange::not_reached) << coarse.sentence;
  const auto floor = range([](double h) { return 1e-3 + h * h; });
  EXPECT_EQ(floor.range, AsymptoticRange::not_reached) << floor.sentence;
  const auto stagnant = range([](double h) { return 1 + h * h; });
  EXPECT_EQ(stagnant.range, AsymptoticRange::not_reached);
  EXPECT_NE(stagnant.sentence.find("hardly falls"), std::string::npos) << stagnant.sentence;
  const auto rising = range([](double h) { return 1 / h; });
  EXPECT_EQ(rising.sentence, "not reached: orders -1.00 and -1.00 on the three finest, the error does not fall");
}

TEST(Convergence, TheRangeNeedsThreeResolutionsApart) {
  EXPECT_EQ(asymptotic_range({0.1, 0.05}, {4e-2, 1e-2}).sentence, "unknown: 2 resolutions, three are needed");
  EXPECT_EQ(asymptotic_range({}, {}).range, AsymptoticRange::unknown);
  const Sequence close{0.1, 0.09, 0.081};
  const auto squares = errors_on(close, [](double h) { return h * h; });
  EXPECT_EQ(asymptotic_range(close, squares).sentence,
            "unknown: the three finest span a factor of 1.23 in h, 1.69 is needed");
  EXPECT_EQ(asymptotic_range({0.1, 0.05, 0.025}, {4e-2, 1e-2, 0}).range, AsymptoticRange::unknown);
  EXPECT_EQ(asymptotic_range({0.025, 0.05, 0.1}, {1e-2, 4e-2, 0.16}).range, AsymptoticRange::unknown);
}

}  // namespace
}  // namespace assay::test_convergence
