// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/analysis/findings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "drivers/result/result_json.hpp"

namespace assay::drivers::test_figure_names {
namespace {

TEST(FigureNames, KeysHaveWordsAndUnits) {
  EXPECT_EQ(name_and_unit("error.l2_max"),
            (std::pair<std::string, std::string>("largest L2 error of the displacement", "m")));
  EXPECT_EQ(name_and_unit("error.relative").second, "") << "shown in percent";
  EXPECT_EQ(name_and_unit("step_cpu_s"), (std::pair<std::string, std::string>("processor time of the steps", "s")));
  EXPECT_EQ(name_and_unit("sheet.points"), (std::pair<std::string, std::string>("sheet.points", "")));
}

TEST(FigureNames, EveryKeyWithWordsIsOneOfTheResult) {
  const auto keys = flat_keys();
  int with_words = 0;
  for (const std::string& key : keys) with_words += name_and_unit(key).first != key ? 1 : 0;
  EXPECT_EQ(with_words, 21) << "a key that was renamed has lost its words";
}

TEST(FigureNames, PowersOfTenAreTheNearestNumbers) {
  EXPECT_EQ(rounded_power(-1), 0.1);
  EXPECT_EQ(rounded_power(-5), 1e-5);
  EXPECT_EQ(rounded_power(0), 1);
  EXPECT_EQ(rounded_power(23), 1e23);
  EXPECT_EQ(rounded_power(-320), 1e-320);
  EXPECT_EQ(rounded_power(-400), 0);
  EXPECT_EQ(rounded_power(400), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace assay::drivers::test_figure_names
