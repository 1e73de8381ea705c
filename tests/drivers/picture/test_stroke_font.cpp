// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/picture/stroke_font.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace assay::drivers::test_stroke_font {
namespace {

TEST(StrokeFont, has_all_of_ascii_inside_its_box) {
  const Glyph& unknown = glyph(U'\u4e2d');
  for (char32_t code = 33; code < 127; ++code) {
    const Glyph& shape = glyph(code);
    EXPECT_NE(&shape, &unknown) << static_cast<int>(code);
    double left = 100, right = -100;
    for (const auto& stroke : shape.strokes) {
      for (const GlyphPoint p : stroke) {
        left = std::min(left, p.x);
        right = std::max(right, p.x);
        EXPECT_GE(p.y, -7) << static_cast<int>(code);
        EXPECT_LE(p.y, 24) << static_cast<int>(code);
      }
    }
    EXPECT_GE(left, -1.1) << static_cast<int>(code);
    EXPECT_LE(right, shape.width + 1) << static_cast<int>(code);
  }
  EXPECT_EQ(&glyph(U'\u4e2e'), &unknown);
}

TEST(StrokeFont, digits_stand_in_columns) {
  for (char32_t code = U'1'; code <= U'9'; ++code) EXPECT_EQ(glyph(code).width, glyph(U'0').width);
}

TEST(StrokeFont, reads_utf8_and_survives_what_is_none) {
  EXPECT_EQ(code_points("a\u03b3\u2212\U0001F600"), (std::vector<char32_t>{U'a', U'\u03b3', U'\u2212', U'\U0001F600'}));
  EXPECT_EQ(code_points("\xff\xce"), (std::vector<char32_t>{U'\ufffd', U'\ufffd'}));
  EXPECT_EQ(code_points("\xce"
                        "a"),
            (std::vector<char32_t>{U'\ufffd', U'a'}));
}

TEST(StrokeFont, splits_labels_at_raised_and_lowered_pieces) {
  const auto pieces = label_pieces("u_{exact} 10^{-3}^{");
  ASSERT_EQ(pieces.size(), 5u);
  EXPECT_EQ(pieces[0].text, "u");
  EXPECT_EQ(pieces[1].text, "exact");
  EXPECT_EQ(pieces[1].level, -1);
  EXPECT_EQ(pieces[2].text, " 10");
  EXPECT_EQ(pieces[3].text, "-3");
  EXPECT_EQ(pieces[3].level, 1);
  EXPECT_EQ(pieces[4].text, "^{");
  EXPECT_EQ(pieces[4].level, 0);
  EXPECT_TRUE(label_pieces("").empty());
}

TEST(StrokeFont, raised_text_is_narrower) {
  EXPECT_LT(label_width("^{123}", 10), label_width("123", 10));
  EXPECT_DOUBLE_EQ(label_width("ab", 20), 2 * label_width("ab", 10));
}

}  // namespace
}  // namespace assay::drivers::test_stroke_font
