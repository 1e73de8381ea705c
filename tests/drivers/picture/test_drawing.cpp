// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/picture/drawing.hpp"

#include <gtest/gtest.h>

namespace assay::drivers::test_drawing {
namespace {

Drawing sample() {
  Drawing out{40, 20, "a < b & c", {}};
  out.line({{2, 10}, {38, 10}}, {Ink::Role::series, 1}, 2, 3);
  out.disc({20, 5}, 3, {Ink::Role::grid, 0});
  out.label({20, 18}, "10^{\u22123}<x>", 8, Anchor::middle);
  return out;
}

TEST(Drawing, svg_leaves_colours_to_the_page) {
  const std::string svg = svg_text(sample());
  EXPECT_NE(svg.find("viewBox=\"0 0 40 20\""), std::string::npos);
  EXPECT_NE(svg.find("<title>a &lt; b &amp; c</title>"), std::string::npos);
  EXPECT_NE(svg.find("d=\"M2 10L38 10\""), std::string::npos);
  EXPECT_NE(svg.find("stroke:var(--series-1,#d55e00)"), std::string::npos);
  EXPECT_NE(svg.find("stroke-dasharray:3"), std::string::npos);
  EXPECT_NE(svg.find("fill:currentColor"), std::string::npos);
  EXPECT_NE(
      svg.find(">10<tspan dy=\"-2.88\" font-size=\"5.76\">\u22123</tspan><tspan dy=\"2.88\">&lt;x&gt;</tspan></text>"),
      std::string::npos)
      << svg;
  EXPECT_EQ(svg.find("script"), std::string::npos);
}

TEST(Drawing, raster_is_the_same_figure_at_any_scale) {
  const Canvas twice = raster(sample(), 2);
  EXPECT_EQ(twice.width(), 80);
  EXPECT_EQ(twice.height(), 40);
  EXPECT_EQ(twice.pixel(6, 20), rgb(0xd55e00));
  EXPECT_EQ(twice.pixel(40, 10), rgb(0xdedede));
  EXPECT_EQ(twice.pixel(1, 1), rgb(0xffffff));
}

TEST(Drawing, escapes_for_xml) {
  EXPECT_EQ(escaped("<a href=\"x\">&'\x01\n"), "&lt;a href=&quot;x&quot;&gt;&amp;' \n");
}

TEST(Drawing, what_is_no_utf8_becomes_question_marks) {
  EXPECT_EQ(escaped("\xe9lastic \xff\xfe, \xc3\xa9"), "?lastic ??, \xc3\xa9");
  EXPECT_EQ(escaped("cut \xe2\x82"), "cut ??");
  EXPECT_EQ(escaped("\xed\xa0\x80 \xc0\xaf \xe0\x80\xaf"), "??? ?? ???") << "surrogates, and what is too long";
}

TEST(Drawing, areas_and_tips) {
  Drawing drawing{20, 10, "", {}};
  drawing.area({{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {Ink::Role::fixed, 0, rgb(0x123456)});
  drawing.tip("a < b");
  drawing.label({1, 9}, "n", 8, Anchor::left, {Ink::Role::name, 1});
  const std::string svg = svg_text(drawing);
  EXPECT_NE(svg.find("d=\"M0 0L10 0L10 10L0 10Z\" style=\"fill:#123456\"><title>a &lt; b</title></path>"),
            std::string::npos)
      << svg;
  EXPECT_NE(svg.find("fill:var(--name-1,"), std::string::npos) << svg;
  EXPECT_EQ(raster(drawing, 1).pixel(8, 2), rgb(0x123456));
  EXPECT_EQ(raster(drawing, 1).pixel(15, 5), rgb(0xffffff));
}

}  // namespace
}  // namespace assay::drivers::test_drawing
