// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/picture/colormap.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include <cmath>
#include <limits>

namespace assay::drivers::test_colormap {
namespace {

/// CIE lightness L*.
double lightness(Color c) {
  const auto linear = [](int byte) {
    const double u = byte / 255.0;
    return u <= 0.04045 ? u / 12.92 : std::pow((u + 0.055) / 1.055, 2.4);
  };
  const double y = 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b);
  return 116 * std::cbrt(y) - 16;
}

TEST(ColorMap, viridis_rises_evenly_in_lightness) {
  const double step = (lightness(map_color(ColorMap::viridis, 1)) - lightness(map_color(ColorMap::viridis, 0))) / 20;
  for (int i = 0; i < 20; ++i) {
    const double rise =
        lightness(map_color(ColorMap::viridis, (i + 1) / 20.0)) - lightness(map_color(ColorMap::viridis, i / 20.0));
    EXPECT_GT(rise, 0.5 * step) << i;
    EXPECT_LT(rise, 1.6 * step) << i;
  }
  EXPECT_EQ(map_color(ColorMap::viridis, 0), rgb(0x440154));
  EXPECT_EQ(map_color(ColorMap::viridis, 1), rgb(0xfde725));
}

TEST(ColorMap, diverging_is_lightest_at_zero_and_even_on_both_sides) {
  for (int i = 1; i <= 10; ++i) {
    const double s = i / 20.0;
    const double low = lightness(map_color(ColorMap::diverging, 0.5 - s));
    const double high = lightness(map_color(ColorMap::diverging, 0.5 + s));
    EXPECT_NEAR(low, high, 6) << i;
    EXPECT_LT(low, lightness(map_color(ColorMap::diverging, 0.5 - s + 0.05))) << i;
    EXPECT_LT(high, lightness(map_color(ColorMap::diverging, 0.5 + s - 0.05))) << i;
  }
  const Color below = map_color(ColorMap::diverging, 0.1), above = map_color(ColorMap::diverging, 0.9);
  EXPECT_GT(below.b, below.r);
  EXPECT_GT(above.r, above.b);
}

TEST(ColorMap, clamps_and_marks_what_is_no_number) {
  for (const ColorMap map : {ColorMap::viridis, ColorMap::diverging}) {
    EXPECT_EQ(map_color(map, -1), map_color(map, 0));
    EXPECT_EQ(map_color(map, std::numeric_limits<double>::infinity()), map_color(map, 1));
    EXPECT_EQ(map_color(map, std::numeric_limits<double>::quiet_NaN()), no_value);
  }
}

/// WCAG 2.
double contrast(Color a, Color b) {
  const double x = luminance(a), y = luminance(b);
  return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

TEST(ColorMap, texts_can_be_read) {
  EXPECT_NEAR(contrast(rgb(0), rgb(0xffffff)), 21, 1e-12);
  for (std::size_t k = 0; k < 7; ++k) EXPECT_GE(contrast(series_text_color(k), rgb(0xffffff)), 4.5) << k;
  for (double s = 0; s <= 1; s += 0.01) {
    for (const ColorMap map : {ColorMap::viridis, ColorMap::diverging}) {
      const Color below = map_color(map, s);
      EXPECT_GE(contrast(readable_on(below), below), 4.5) << s;
    }
  }
}

}  // namespace
}  // namespace assay::drivers::test_colormap
