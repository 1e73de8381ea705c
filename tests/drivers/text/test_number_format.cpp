// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/text/numbers.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

namespace assay::drivers::test_number_format {
namespace {

TEST(NumberFormat, rounds_to_significant_digits) {
  EXPECT_EQ(rounded_text(0.0632951, 3), "0.0633");
  EXPECT_EQ(rounded_text(1.0, 4), "1");
  EXPECT_EQ(rounded_text(1234567, 3), "1.23e+06");
  EXPECT_EQ(rounded_text(1.234e-5, 2), "1.2e-05");
  EXPECT_EQ(rounded_text(-0.0, 3), "0");
  EXPECT_EQ(rounded_text(-std::numeric_limits<double>::quiet_NaN(), 3), "nan");
}

TEST(NumberFormat, shortens_what_is_a_number) {
  EXPECT_EQ(shortened("0.06591705990531865", 4), "0.06592");
  EXPECT_EQ(shortened("completed", 4), "completed");
  EXPECT_EQ(shortened("null", 4), "null");
}

TEST(NumberFormat, groups_thousands) {
  EXPECT_EQ(grouped_text(0), "0");
  EXPECT_EQ(grouped_text(999), "999");
  EXPECT_EQ(grouped_text(1000), "1,000");
  EXPECT_EQ(grouped_text(-123456), "-123,456");
  EXPECT_EQ(grouped_text(std::numeric_limits<std::int64_t>::min()), "-9,223,372,036,854,775,808");
}

}  // namespace
}  // namespace assay::drivers::test_number_format
