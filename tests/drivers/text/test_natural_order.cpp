// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/text/natural_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace assay::drivers::test_natural_order {
namespace {

TEST(NaturalOrder, NumbersInNamesCountAsNumbers) {
  std::vector<std::string> names{"step_10", "step_9", "a2b10", "step_1", "a2b9", "a10b1", "step", "step_1.csv"};
  std::ranges::sort(names, in_natural_order);
  EXPECT_EQ(names,
            (std::vector<std::string>{"a2b9", "a2b10", "a10b1", "step", "step_1", "step_1.csv", "step_9", "step_10"}));
}

TEST(NaturalOrder, NumbersBeyondAllIntegersAndLeadingZeros) {
  EXPECT_TRUE(in_natural_order("p_99999999999999999999", "p_100000000000000000000"));
  EXPECT_TRUE(in_natural_order("p_007", "p_08"));
  EXPECT_FALSE(in_natural_order("p_08", "p_007"));
  EXPECT_FALSE(in_natural_order("p_07", "p_7"));
  EXPECT_FALSE(in_natural_order("p_7", "p_07"));
}

}  // namespace
}  // namespace assay::drivers::test_natural_order
