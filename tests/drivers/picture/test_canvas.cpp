// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/picture/canvas.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/png.hpp"

namespace assay::drivers::test_canvas {
namespace {

constexpr Color white = rgb(0xffffff), black = rgb(0x000000), red = rgb(0xff0000);

/// Sum of the darkness of all pixels: the area drawn in black, in pixels.
double area(const Canvas& canvas) {
  double sum = 0;
  for (int y = 0; y < canvas.height(); ++y) {
    for (int x = 0; x < canvas.width(); ++x) sum += (255 - canvas.pixel(x, y).r) / 255.0;
  }
  return sum;
}

TEST(Canvas, colours) {
  EXPECT_EQ(rgb(0x123456), (Color{0x12, 0x34, 0x56}));
  EXPECT_EQ(mix(black, white, 0.5), (Color{128, 128, 128}));
  EXPECT_EQ(mix(black, red, 7), red);
}

TEST(Canvas, fills_the_inside_with_partial_edges) {
  Canvas canvas(20, 20, white);
  const std::array<Point, 4> square{{{2.5, 3}, {10, 3}, {10, 9.25}, {2.5, 9.25}}};
  canvas.fill(square, black);
  EXPECT_NEAR(area(canvas), 7.5 * 6.25, 1e-1);
  EXPECT_EQ(canvas.pixel(5, 5), black);
  EXPECT_EQ(canvas.pixel(1, 5), white);
  EXPECT_NEAR(canvas.pixel(2, 5).r, 127, 1);
  EXPECT_NEAR(canvas.pixel(5, 9).r, 191, 1);
}

TEST(Canvas, circle_and_line_have_their_areas) {
  Canvas circle(60, 60, white);
  circle.circle({30, 30}, 20, black);
  EXPECT_NEAR(area(circle), 400 * std::acos(-1.0), 4);
  Canvas line(60, 60, white);
  line.stroke(std::array<Point, 2>{{{10, 12}, {40, 52}}}, 4, black);
  EXPECT_NEAR(area(line), 50 * 4 + 4 * std::acos(-1.0), 4);  // with round ends
  Canvas dashed(120, 20, white);
  dashed.stroke(std::array<Point, 3>{{{10, 10}, {57, 10}, {110, 10}}}, 1, black, 10);
  EXPECT_NEAR(area(dashed), 50 + 5 * std::acos(-1.0) / 4, 3);
}

TEST(Canvas, neighbours_leave_neither_seam_nor_overlap) {
  // A fan of triangles around a point that is on no sample: every sample of the square belongs to exactly one.
  constexpr double cx = 20.13, cy = 19.71;
  double sum = 0;
  Canvas all(40, 40, white);
  const std::array<Point, 7> rim{{{0, 0}, {17.3, 0}, {40, 0}, {40, 40}, {11.1, 40}, {0, 40}, {0, 0}}};
  for (std::size_t i = 0; i + 1 < rim.size(); ++i) {
    const std::array<Point, 3> triangle{{rim[i], rim[i + 1], {cx, cy}}};
    all.fill(triangle, black);
    Canvas one(40, 40, white);
    one.fill(triangle, black);
    sum += area(one);
  }
  EXPECT_EQ(area(all), 1600);
  EXPECT_NEAR(sum, 1600, 1);  // rounding of the partly covered pixels to bytes
}

TEST(Canvas, draws_nothing_outside_or_not_finite) {
  Canvas canvas(10, 10, white);
  canvas.clip(2, 2, 5, 5);
  const std::array<Point, 4> huge{{{-1e300, -1e300}, {1e300, -1e300}, {1e300, 1e300}, {-1e300, 1e300}}};
  canvas.fill(huge, black);
  EXPECT_EQ(area(canvas), 9);
  canvas.unclip();
  canvas.fill(std::array<Point, 3>{{{NAN, 0}, {10, 0}, {10, 10}}}, black);
  canvas.circle({INFINITY, 5}, 3, black);
  canvas.circle({5, 5}, -3, black);
  canvas.stroke(std::array<Point, 2>{{{0, 8}, {NAN, 8}}}, 2, black);
  canvas.stroke(std::array<Point, 2>{{{-50, 800}, {50, 800}}}, 2, black);
  EXPECT_EQ(area(canvas), 9);
}

TEST(Canvas, text_keeps_to_its_anchor) {
  const auto ink = [](const Canvas& canvas) {
    std::array<int, 4> box{1000, 1000, -1, -1};
    for (int y = 0; y < canvas.height(); ++y) {
      for (int x = 0; x < canvas.width(); ++x) {
        if (canvas.pixel(x, y) == white) continue;
        box = {std::min(box[0], x), std::min(box[1], y), std::max(box[2], x), std::max(box[3], y)};
      }
    }
    return box;
  };
  Canvas left(200, 60, white), right(200, 60, white), middle(200, 60, white), up(60, 200, white);
  left.text({100, 40}, "H0.5H", {20, black, Anchor::left, false});
  right.text({100, 40}, "H0.5H", {20, black, Anchor::right, false});
  middle.text({100, 40}, "H0.5H", {20, black, Anchor::middle, false});
  up.text({40, 100}, "H0.5H", {20, black, Anchor::middle, true});
  EXPECT_NEAR(ink(left)[0], 99, 1);
  EXPECT_NEAR(ink(right)[2], 100, 1);
  EXPECT_NEAR(ink(middle)[0] + ink(middle)[2], 199, 2);
  EXPECT_NEAR(ink(up)[1] + ink(up)[3], 199, 2);
  EXPECT_NEAR(ink(left)[3], 40, 1);                   // the baseline
  EXPECT_NEAR(40 - ink(left)[1], 20.0 * 20 / 28, 2);  // the capitals' height
  EXPECT_NEAR(ink(up)[2] - ink(up)[0], ink(left)[3] - ink(left)[1], 1);
}

TEST(Canvas, png_holds_the_pixels_and_is_deterministic) {
  const auto draw = [] {
    Canvas canvas(31, 17, rgb(0x10fa20));
    canvas.circle({12, 9}, 6.3, red);
    canvas.text({3, 12}, "ab", {10, black, Anchor::left, false});
    return canvas;
  };
  const Canvas canvas = draw();
  const std::string bytes = canvas.png();
  EXPECT_EQ(bytes, draw().png());
  int width = 0, height = 0, channels = 0;
  unsigned char* pixels = stbi_load_from_memory(reinterpret_cast<const unsigned char*>(bytes.data()),
                                                static_cast<int>(bytes.size()), &width, &height, &channels, 3);
  ASSERT_NE(pixels, nullptr);
  ASSERT_EQ(width, 31);
  ASSERT_EQ(height, 17);
  for (int i = 0; i < 31 * 17; ++i) {
    EXPECT_EQ((Color{pixels[3 * i], pixels[3 * i + 1], pixels[3 * i + 2]}), canvas.pixel(i % 31, i / 31));
  }
  stbi_image_free(pixels);
}

}  // namespace
}  // namespace assay::drivers::test_canvas
