// SPDX-License-Identifier: BSD-3-Clause
#include "harness/motion/amplitude.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace assay::test_amplitude {
namespace {

constexpr double step = 1e-4;
/// Central differences of a function with derivatives of order pi^4: step^2 / 6 * 400, and round-off / step^2.
constexpr double difference_error = 1e-5;

class AmplitudeRates : public testing::TestWithParam<Amplitude::Type> {};

TEST_P(AmplitudeRates, AgreeWithDifferences) {
  const Amplitude g{GetParam(), 1.7, 0.8};
  for (const double t : {0.05, 0.21, 0.39, 0.63, 0.77}) {
    const double before = g.at(t - step).value, here = g.at(t).value, after = g.at(t + step).value;
    EXPECT_NEAR(g.at(t).rate, (after - before) / (2 * step), difference_error);
    EXPECT_NEAR(g.at(t).acceleration, (after - 2 * here + before) / (step * step), 100 * difference_error);
  }
}

TEST_P(AmplitudeRates, ChangeTheirSignAtReversalsOnly) {
  const Amplitude g{GetParam(), 1.0, 0.5};
  const double end = 2.3;
  std::vector<double> found;
  for (int k = 1; k < 23000; ++k) {
    const double t = 1e-4 * k, a = g.at(t - 0.5e-4).rate, b = g.at(t + 0.5e-4).rate;
    if ((a > 0) != (b > 0)) found.push_back(t);
  }
  const auto told = g.reversals(end);
  ASSERT_EQ(told.size(), found.size());
  for (std::size_t i = 0; i < told.size(); ++i) EXPECT_NEAR(told[i], found[i], 1e-4);
}

INSTANTIATE_TEST_SUITE_P(All, AmplitudeRates,
                         testing::Values(Amplitude::Type::sine, Amplitude::Type::one_minus_cosine,
                                         Amplitude::Type::ramp));

TEST(Amplitude, HasTheValuesOfItsFormula) {
  const double A = 0.3, T = 2;
  EXPECT_DOUBLE_EQ((Amplitude{Amplitude::Type::sine, A, T}.at(0.5).value), A * std::sin(std::numbers::pi / 4));
  EXPECT_NEAR((Amplitude{Amplitude::Type::one_minus_cosine, A, T}.at(0.5).value), A / 2, 1e-16);
  EXPECT_DOUBLE_EQ((Amplitude{Amplitude::Type::ramp, A, T}.at(0.5).value), A / 4);
}

TEST(Amplitude, LosesNothingAtLateTimes) {
  for (const auto type : {Amplitude::Type::sine, Amplitude::Type::one_minus_cosine}) {
    const Amplitude g{type, 1, 2};
    const double late = 4 * 0x1p40 + 0.75;  // whole periods later, exact in binary
    EXPECT_EQ(g.at(late).value, g.at(0.75).value);
    EXPECT_EQ(g.at(late).rate, g.at(0.75).rate);
  }
}

TEST(Amplitude, RampHolds) {
  const Amplitude g{Amplitude::Type::ramp, 2.0, 1.0};
  EXPECT_EQ(g.at(3).value, 2.0);
  EXPECT_EQ(g.at(3).rate, 0.0);
}

TEST(Amplitude, OneMinusCosineStartsFromRest) {
  const AmplitudeValue start = Amplitude{Amplitude::Type::one_minus_cosine, 1, 1}.at(0);
  EXPECT_EQ(start.value, 0);
  EXPECT_EQ(start.rate, 0);
}

TEST(Amplitude, APeriodOfTheSmallestNumberHasNoReversals) {
  const double smallest = std::numeric_limits<double>::denorm_min();
  EXPECT_TRUE((Amplitude{Amplitude::Type::one_minus_cosine, 0.1, smallest}).reversals(1).empty());
  EXPECT_TRUE(times_before(1, [](double) { return 0.5; }).empty());
  EXPECT_EQ(times_before(1, [](double k) { return 0.3 * (k + 1); }), (std::vector{0.3, 0.6, 0.3 * 3}));
}

}  // namespace
}  // namespace assay::test_amplitude
