// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/picture/author_units.hpp"

#include <gtest/gtest.h>

namespace assay::drivers::test_author_units {
namespace {

const Units author{.length = "mm", .stress = "MPa", .time = "ms"};
using Values = std::vector<double>;

TEST(AuthorUnits, AreThoseOfTheLabels) {
  const LinePlot plot =
      in_units(LinePlot{"", "t [s]", "tau [Pa]", false, false, {{.name = "", .x = {0, 0.5}, .y = {1e6, 2e6}}}}, author);
  EXPECT_EQ(plot.x_label, "t [ms]");
  EXPECT_EQ(plot.y_label, "tau [MPa]");
  EXPECT_EQ(plot.series[0].x, (Values{0, 500}));
  EXPECT_EQ(plot.series[0].y, (Values{1, 2}));
  const LinePlot plain =
      in_units(LinePlot{"", "xi [1]", "error", false, false, {{.name = "", .x = {3}, .y = {4}}}}, author);
  EXPECT_EQ(plain.x_label, "xi [1]");
  EXPECT_EQ(plain.series[0].y, (Values{4}));
}

TEST(AuthorUnits, OfMaps) {
  HeatMap map;
  map.x_label = "t [s]", map.y_label = "xi [1]", map.value_label = "tau [Pa]";
  map.values = {1e6}, map.x = {0, 2}, map.y = {0, 3}, map.lines = {{{1, 1}}};
  const HeatMap own = in_units(map, author);
  EXPECT_EQ(own.values, (Values{1}));
  EXPECT_EQ(own.x[1], 2000);
  EXPECT_EQ(own.y[1], 3);
  EXPECT_EQ(own.lines[0][0].x, 1000);
  EXPECT_EQ(own.value_label, "tau [MPa]");
}

TEST(AuthorUnits, OfParticles) {
  ParticlePicture picture;
  picture.value_label = "error [m]", picture.range = {0, 0.1}, picture.rings = {0.75};
  picture.frames.push_back({"", {1}, {2}, {0.1}, {0}, {0}, {0.1}, {0.05}, {{{1, 2}}}});
  const ParticlePicture own = in_units(picture, author);
  EXPECT_EQ(own.length_unit, "mm");
  EXPECT_EQ(own.value_label, "error [mm]");
  EXPECT_EQ(own.frames[0].x, (Values{1000}));
  EXPECT_EQ(own.frames[0].r2y, (Values{100}));
  EXPECT_EQ(own.frames[0].value, (Values{50}));
  EXPECT_EQ(own.frames[0].polygons[0][0].y, 2000);
  EXPECT_EQ((*own.range)[1], 100);
  EXPECT_EQ(own.rings, (Values{750}));
  EXPECT_EQ(own.upper[0], 1500);
}

}  // namespace
}  // namespace assay::drivers::test_author_units
