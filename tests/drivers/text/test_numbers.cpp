// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/text/numbers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

namespace assay::drivers::test_numbers {
namespace {

TEST(Numbers, ReadsDecimals) {
  EXPECT_EQ(parse_number("2"), 2);
  EXPECT_EQ(parse_number("-1.5"), -1.5);
  EXPECT_EQ(parse_number("1e3"), 1000);
  EXPECT_EQ(parse_number("1.0E+03"), 1000);
  EXPECT_EQ(parse_number(".5"), 0.5);
  EXPECT_EQ(parse_number("+2."), 2);
  EXPECT_EQ(parse_number("007"), 7);
  EXPECT_EQ(parse_number("-.inf"), -std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(parse_number(".nan").value()));
  EXPECT_TRUE(std::signbit(parse_number("-0").value()));
}

TEST(Numbers, ReadsNothingElse) {
  for (const char* text :
       {"",    " ",   "1 ",  " 1",  "1,5",      "0x10",  "1e",    "1e+",   "e3",     ".",   "-",    "+",
        "--1", "+-1", "inf", "nan", "infinity", "1_000", "1.2.3", "1e400", "1e-400", "1d3", "true", "\xd9\xa1"}) {
    EXPECT_EQ(parse_number(text), std::nullopt) << text;
  }
}

TEST(Numbers, WholeNumbers) {
  EXPECT_EQ(parse_integer("12"), 12);
  EXPECT_EQ(parse_integer("+12"), 12);
  EXPECT_EQ(parse_integer("-12"), -12);
  for (const char* text : {"", "+", "-", "+-1", "1.0", "1e3", " 1", "99999999999999999999", "0x1"}) {
    EXPECT_EQ(parse_integer(text), std::nullopt) << text;
  }
}

TEST(Numbers, RoundTripByTheShortestText) {
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_EQ(number_text(1000), "1000");
  std::mt19937_64 random(7);
  for (int i = 0; i < 20000; ++i) {
    const std::uint64_t bits = random();
    double value = 0;
    std::memcpy(&value, &bits, sizeof value);
    if (!std::isfinite(value) || (value != 0 && std::abs(value) < std::numeric_limits<double>::min())) continue;
    ASSERT_EQ(parse_number(number_text(value)), value) << number_text(value);
  }
}

}  // namespace
}  // namespace assay::drivers::test_numbers
