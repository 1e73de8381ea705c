// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/picture/line_plot.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace assay::drivers::test_line_plot {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// What was drawn for series k.
std::vector<DrawingItem> items_of(const Drawing& drawing, std::size_t series, DrawingItem::Kind kind) {
  std::vector<DrawingItem> out;
  for (const DrawingItem& item : drawing.items) {
    if (item.kind == kind && item.ink.role == Ink::Role::series && item.ink.series == series) out.push_back(item);
  }
  return out;
}

bool has_label(const Drawing& drawing, const std::string& text) {
  return std::any_of(drawing.items.begin(), drawing.items.end(), [&](const DrawingItem& i) { return i.label == text; });
}

TEST(LinePlot, curve_goes_where_its_points_are) {
  const Drawing drawing = draw({"", "t [s]", "u [m]", false, false, {{"", {0, 0.5, 1}, {0, 1, 0.5}}}});
  const auto lines = items_of(drawing, 0, DrawingItem::Kind::line);
  ASSERT_EQ(lines.size(), 1u);
  const auto& p = lines[0].points;
  ASSERT_EQ(p.size(), 3u);
  EXPECT_NEAR(p[1].x, (p[0].x + p[2].x) / 2, 1e-9);
  EXPECT_NEAR(p[2].y, (p[0].y + p[1].y) / 2, 1e-9);
  EXPECT_LT(p[1].y, p[0].y);  // upwards is less
  EXPECT_TRUE(has_label(drawing, "t [s]"));
  EXPECT_TRUE(has_label(drawing, "u [m]"));
}

TEST(LinePlot, gaps_where_points_cannot_be_drawn) {
  const Drawing linear = draw({"", "", "", false, false, {{"", {0, 1, 2, 3, 4}, {0, 1, nan, 0, 1}}}});
  EXPECT_EQ(items_of(linear, 0, DrawingItem::Kind::line).size(), 2u);
  const Drawing logarithmic = draw({"", "", "", false, true, {{"", {0, 1, 2, 3, 4}, {0, 1, 2, -1, 1}}}});
  EXPECT_EQ(items_of(logarithmic, 0, DrawingItem::Kind::line).size(), 1u);  // 1, 2; the last one is alone
  EXPECT_EQ(items_of(logarithmic, 0, DrawingItem::Kind::disc).size(), 1u);
  EXPECT_TRUE(has_label(logarithmic, "0.0"));  // the axis starts at t = 0 although its error cannot be drawn
}

TEST(LinePlot, one_point_and_none_are_drawn_sensibly) {
  EXPECT_EQ(items_of(draw({"", "", "", false, false, {{"", {1}, {3e-4}}}}), 0, DrawingItem::Kind::disc).size(), 1u);
  for (const bool log : {false, true}) {
    EXPECT_TRUE(has_label(draw({"", "x", "y", log, log, {}}), "no data"));
    EXPECT_TRUE(has_label(draw({"", "x", "y", log, log, {{"s", {nan, 1}, {1, nan}}}}), "no data"));
  }
}

TEST(LinePlot, legend_stands_above_all_curves) {
  std::vector<Series> series;
  for (int k = 0; k < 9; ++k) series.push_back({"a rather long name " + std::to_string(k), {0, 1}, {1.0 * k, 2.0 * k}});
  const Drawing drawing = draw({"Title", "", "", false, false, series});
  double lowest_name = 0, highest_point = 1e9;
  for (const DrawingItem& item : drawing.items) {
    if (item.label.starts_with("a rather long")) {
      lowest_name = std::max(lowest_name, item.points[0].y);
      EXPECT_LT(item.points[0].x, drawing.width - 100);
    }
  }
  for (std::size_t k = 0; k < series.size(); ++k) {
    const auto lines = items_of(drawing, k, DrawingItem::Kind::line);
    ASSERT_EQ(lines.size(), 2u);  // in the legend, in the plot
    for (const Point p : lines[1].points) highest_point = std::min(highest_point, p.y);
  }
  EXPECT_LT(lowest_name, highest_point);
}

TEST(LinePlot, everything_stays_inside) {
  const Drawing drawing =
      draw({"Title", "x", "y", true, true, {{"s", {1e-300, 1, 1e300}, {1e-9, 5, 1e250}, true, true}}});
  for (const DrawingItem& item : drawing.items) {
    for (const Point p : item.points) {
      EXPECT_GE(p.x, 0);
      EXPECT_LE(p.x, drawing.width);
      EXPECT_GE(p.y, 0);
      EXPECT_LE(p.y, drawing.height);
    }
  }
}

TEST(LinePlot, same_plot_same_bytes) {
  const LinePlot plot{"T", "x", "y", false, true, {{"s", {0, 1, 2}, {1, 10, 5}}}};
  EXPECT_EQ(svg(plot), svg(plot));
  EXPECT_EQ(png(plot), png(plot));
  EXPECT_TRUE(png(plot).starts_with("\x89PNG"));
}

}  // namespace
}  // namespace assay::drivers::test_line_plot
