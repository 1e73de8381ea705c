// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/result/json_figure.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace assay::drivers::test_json_figure {
namespace {

TEST(JsonFigure, WhatIsNoNumberIsNull) {
  EXPECT_EQ(json_figure(1.5), 1.5);
  EXPECT_TRUE(json_figure(std::nullopt).is_null());
  EXPECT_TRUE(json_figure(INFINITY).is_null());
  EXPECT_TRUE(json_figure(-INFINITY).is_null());
  EXPECT_TRUE(json_figure(NAN).is_null());
}

TEST(JsonFigure, AnEmptyTextIsNull) {
  EXPECT_EQ(json_text("a"), "a");
  EXPECT_TRUE(json_text("").is_null());
}

}  // namespace
}  // namespace assay::drivers::test_json_figure
