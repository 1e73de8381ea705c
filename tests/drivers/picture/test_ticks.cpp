// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/picture/ticks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace assay::drivers::test_ticks {
namespace {

TEST(Ticks, linear_labels) {
  const Axis axis = make_axis(0, 1, false, Fit::tight);
  EXPECT_EQ(axis.labels, (std::vector<std::string>{"0.0", "0.2", "0.4", "0.6", "0.8", "1.0"}));
  EXPECT_TRUE(axis.factor.empty());
  EXPECT_EQ(make_axis(-2, 2, false, Fit::tight, 4).labels,
            (std::vector<std::string>{"\u22122", "\u22121", "0", "1", "2"}));
}

TEST(Ticks, small_and_large_values_share_a_factor) {
  const Axis axis = make_axis(0, 3e-4, false, Fit::rounded);
  EXPECT_EQ(axis.factor, "\u00d710^{\u22124}");
  EXPECT_EQ(axis.labels.front(), "0.0");
  EXPECT_EQ(axis.labels.back(), "3.0");
}

TEST(Ticks, logarithmic_marks_decades_and_between) {
  const Axis axis = make_axis(3e-5, 0.2, true, Fit::rounded);
  EXPECT_DOUBLE_EQ(axis.low, 1e-5);
  EXPECT_DOUBLE_EQ(axis.high, 1);
  EXPECT_EQ(axis.labels.size(), 6u);
  EXPECT_EQ(axis.labels[0], "10^{\u22125}");
  EXPECT_EQ(axis.labels[5], "10^{0}");
  EXPECT_EQ(axis.minor.size(), 40u);
  EXPECT_EQ(make_axis(10, 90, true, Fit::rounded).labels, (std::vector<std::string>{"10", "20", "50", "100"}));
}

TEST(Ticks, fraction_maps_the_ends) {
  for (const bool logarithmic : {false, true}) {
    const Axis axis = make_axis(0.3, 47, logarithmic, Fit::tight);
    EXPECT_NEAR(axis.fraction(axis.low), 0, 1e-12);
    EXPECT_NEAR(axis.fraction(axis.high), 1, 1e-12);
  }
  EXPECT_NEAR(make_axis(1, 100, true, Fit::tight).fraction(10), 0.5, 1e-12);
}

// Any data gives an axis that holds it, with a readable number of different labels.
TEST(Ticks, hold_for_any_range) {
  for (const double scale : {1e-300, 1e-12, 3e-4, 0.7, 1.0, 42.0, 6.1e5, 1e200}) {
    for (const double from : {0.0, -1.0, 0.999, 1.0, 1e-8}) {
      for (const bool logarithmic : {false, true}) {
        for (const Fit fit : {Fit::tight, Fit::rounded}) {
          const double low = from * scale, high = scale;
          if (logarithmic && low <= 0) continue;
          const Axis axis = make_axis(low, high, logarithmic, fit);
          const std::string what = std::to_string(from) + " " + std::to_string(std::log10(scale)) +
                                   (logarithmic ? " log" : " linear") + (fit == Fit::tight ? " tight" : " rounded");
          EXPECT_LT(axis.low, axis.high) << what;
          if (scale > 1e-290) {
            EXPECT_LE(axis.low, low + 1e-6 * scale) << what;
            EXPECT_GE(axis.high, high * (1 - 1e-6)) << what;
          }
          EXPECT_EQ(axis.major.size(), axis.labels.size());
          EXPECT_LE(axis.major.size(), 14u) << what;
          EXPECT_EQ(std::set<std::string>(axis.labels.begin(), axis.labels.end()).size(), axis.labels.size()) << what;
          EXPECT_TRUE(fit == Fit::tight || axis.major.size() >= 2) << what;
        }
      }
    }
  }
}

}  // namespace
}  // namespace assay::drivers::test_ticks
