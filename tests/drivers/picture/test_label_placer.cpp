// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/picture/label_placer.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace assay::drivers::test_label_placer {
namespace {

constexpr LabelBox label_room{0, 0, 400, 300};

TEST(LabelPlacer, a_line_crosses_a_box_or_not) {
  const LabelBox box{10, 10, 20, 20};
  EXPECT_TRUE(crosses({0, 0}, {30, 30}, box));
  EXPECT_TRUE(crosses({15, 15}, {16, 15}, box));
  EXPECT_TRUE(crosses({15, 0}, {15, 30}, box));
  EXPECT_FALSE(crosses({0, 0}, {9, 9}, box));
  EXPECT_FALSE(crosses({0, 25}, {30, 25}, box));
  EXPECT_FALSE(crosses({0, 12}, {12, 0}, {14, 14, 20, 20}));
}

TEST(LabelPlacer, labels_keep_off_one_another_and_inside) {
  LabelPlacer placer(label_room);
  std::vector<LabelBox> placed;
  for (int i = 0; i < 60; ++i) {
    const std::vector<Point> anchors{{200 + 20 * std::cos(1.0 * i), 150 + 20 * std::sin(1.0 * i)}};
    const auto place = placer.place({70, 16}, anchors);
    if (place) placed.push_back(place->box);
  }
  EXPECT_GT(placed.size(), 12u);
  EXPECT_LT(placed.size(), 60u);  // there is no room for all of them
  for (std::size_t i = 0; i < placed.size(); ++i) {
    EXPECT_TRUE(placed[i].left >= 0 && placed[i].right <= 400 && placed[i].top >= 0 && placed[i].bottom <= 300);
    for (std::size_t k = 0; k < i; ++k) EXPECT_FALSE(overlap(placed[i], placed[k])) << i << " on " << k;
  }
}

TEST(LabelPlacer, close_by_where_there_is_room) {
  LabelPlacer placer(label_room);
  const std::vector<Point> anchors{{200, 150}, {20, 20}};
  const auto place = placer.place({70, 16}, anchors);
  ASSERT_TRUE(place);
  EXPECT_EQ(place->anchor.x, 200);
  EXPECT_LT(place->distance, 10);
}

TEST(LabelPlacer, rather_beside_a_line_than_on_it) {
  LabelPlacer placer(label_room);
  const std::vector<Point> line{{0, 140}, {400, 140}};
  placer.avoid(line);
  const auto place = placer.place({70, 16}, std::vector<Point>{{200, 150}});
  ASSERT_TRUE(place);
  EXPECT_GT(place->box.top, 140);
  std::vector<Point> hatching;
  for (double y = 0; y <= 300; y += 10) hatching.insert(hatching.end(), {{0, y}, {400, y}, {0, y}});
  placer.avoid(hatching);
  EXPECT_FALSE(placer.place({70, 16}, std::vector<Point>{{200, 150}}, 110, false));
  EXPECT_TRUE(placer.place({70, 16}, std::vector<Point>{{200, 150}}, 110, true));
}

TEST(LabelPlacer, none_where_it_cannot_be) {
  LabelPlacer placer(label_room);
  EXPECT_FALSE(placer.place({500, 16}, std::vector<Point>{{200, 150}}));
  EXPECT_FALSE(placer.place({50, 16}, {}));
  placer.keep_off(label_room);
  EXPECT_FALSE(placer.place({50, 16}, std::vector<Point>{{200, 150}}));
}

}  // namespace
}  // namespace assay::drivers::test_label_placer
