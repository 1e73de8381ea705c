// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/picture/value_pictures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "tests/drivers/sample_vortex.hpp"
#include "tests/support/png.hpp"

namespace assay::drivers::test_particle_picture {
namespace {

struct Image {
  int width = 0, height = 0;
  std::vector<Color> pixels;
  Color at(double x, double y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
  }
  int count(Color color) const {
    int sum = 0;
    for (const Color& pixel : pixels) sum += pixel == color;
    return sum;
  }
};

Image decode(const std::string& bytes) {
  Image out;
  int channels = 0;
  unsigned char* data = stbi_load_from_memory(reinterpret_cast<const unsigned char*>(bytes.data()),
                                              static_cast<int>(bytes.size()), &out.width, &out.height, &channels, 3);
  if (!data) return out;
  for (int i = 0; i < out.width * out.height; ++i)
    out.pixels.push_back({data[3 * i], data[3 * i + 1], data[3 * i + 2]});
  stbi_image_free(data);
  return out;
}

/// One square of 1 m around the origin on a panel of 700 pixels for 3 m; without title and caption its top is at 18.
ParticlePicture one_square(double value) {
  ParticlePicture picture;
  picture.frames = {{"", {0}, {0}, {0.5}, {0}, {0}, {0.5}, {value}}};
  picture.range = {0, 1};
  return picture;
}

TEST(ParticlePicture, particle_covers_its_domain_in_its_colour) {
  const Image image = decode(png(one_square(0.5)));
  ASSERT_GT(image.width, 800);
  const Color color = map_color(ColorMap::viridis, 0.5);
  const double cx = 78 + 350, cy = 18 + 350, reach = 700.0 / 6;
  for (const double sx : {-1, 1}) {
    for (const double sy : {-1, 1}) {
      EXPECT_EQ(image.at(cx + sx * (reach - 4), cy + sy * (reach - 4)), color);
      EXPECT_EQ(image.at(cx + sx * (reach + 4), cy + sy * (reach - 4)), rgb(0xffffff));
    }
  }
  EXPECT_NEAR(image.count(color), 4 * reach * reach, 0.03 * 4 * reach * reach);
}

TEST(ParticlePicture, what_has_no_value_is_grey) {
  EXPECT_GT(decode(png(one_square(std::nan("")))).count(no_value), 50000);
}

TEST(ParticlePicture, sheared_domain_is_a_parallelogram) {
  ParticlePicture picture = one_square(0);
  picture.frames[0].r2x = {0.5};  // leans to the right going up
  const Image image = decode(png(picture));
  const Color color = map_color(ColorMap::viridis, 0);
  const double cx = 78 + 350, cy = 18 + 350, reach = 700.0 / 6;
  EXPECT_EQ(image.at(cx + 1.8 * reach, cy - 0.95 * reach), color);
  EXPECT_EQ(image.at(cx - 1.8 * reach, cy + 0.95 * reach), color);
  EXPECT_EQ(image.at(cx - 0.9 * reach, cy - 0.95 * reach), rgb(0xffffff));
}

TEST(ParticlePicture, particles_far_away_or_not_finite_do_no_harm) {
  ParticlePicture picture;
  const double inf = INFINITY;
  picture.frames = {
      {"", {1e200, NAN, 2}, {0, 0, inf}, {1e300, 1, 1}, {0, 0, 0}, {0, 0, 0}, {1e300, 1, 1}, {inf, 1, NAN}}};
  EXPECT_GT(decode(png(picture)).width, 0);
  picture.frames = {{}};  // no particle at all
  EXPECT_GT(decode(png(picture)).width, 0);
}

TEST(ParticlePicture, vortex_fills_the_ring_without_cracks) {
  ParticlePicture picture;
  picture.map = ColorMap::diverging;
  picture.frames = {sample_vortex(0.025, 0.5)};
  EXPECT_GT(picture.frames[0].x.size(), 4900u);
  const std::string bytes = png(picture);
  EXPECT_EQ(bytes, png(picture));
  const Image image = decode(bytes);
  int cracks = 0, looked_at = 0;
  for (int y = 0; y < 700; ++y) {
    for (int x = 0; x < 700; ++x) {
      const double R = std::hypot(x - 349.5, y - 349.5) * 3 / 700;
      if (R < 0.8 || R > 1.2) continue;
      ++looked_at;
      cracks += image.at(78 + x, 18 + y) == rgb(0xffffff);
    }
  }
  EXPECT_GT(looked_at, 100000);
  EXPECT_LE(cracks, looked_at / 1000);
}

TEST(ParticlePicture, several_frames_stand_side_by_side) {
  ParticlePicture picture;
  picture.title = "Shear";
  picture.lower = {-1.3, -1.3};
  picture.upper = {1.3, 1.3};
  for (const double t : {0.0, 0.5, 1.0}) picture.frames.push_back(sample_vortex(0.05, t));
  const Image image = decode(png(picture));
  EXPECT_GT(image.width, 2 * image.height);
}

/// One square as a polygon, with the shade of a face that is turned from the light.
ParticlePicture one_polygon(double shade) {
  ParticlePicture picture;
  picture.frames = {{"", {}, {}, {}, {}, {}, {}, {1}, {{{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}}, {shade}}};
  picture.range = {0, 1};
  return picture;
}

TEST(ParticlePicture, shaded_polygons_are_darker) {
  const Color yellow = map_color(ColorMap::viridis, 1);
  const double cx = 78 + 350, cy = 18 + 350;
  EXPECT_EQ(decode(png(one_polygon(0))).at(cx, cy), yellow);
  EXPECT_EQ(decode(png(one_polygon(0.25))).at(cx, cy), mix(yellow, rgb(0), 0.25));
}

TEST(ParticlePicture, what_is_later_hides_what_is_behind_it) {
  ParticlePicture picture = one_polygon(0);
  ParticleFrame& frame = picture.frames[0];
  frame.polygons.push_back({{-0.2, -0.2}, {0.2, -0.2}, {0.2, 0.2}, {-0.2, 0.2}});
  frame.value.push_back(0);
  frame.shade.push_back(0);
  const double cx = 78 + 350, cy = 18 + 350;
  EXPECT_EQ(decode(png(picture)).at(cx, cy), map_color(ColorMap::viridis, 0));
  std::swap(frame.polygons[0], frame.polygons[1]);
  std::swap(frame.value[0], frame.value[1]);
  EXPECT_EQ(decode(png(picture)).at(cx, cy), map_color(ColorMap::viridis, 1));
}

/// A large polygon among slivers has no outline, for a line around it alone would say something.
TEST(ParticlePicture, outlines_are_around_most_polygons_or_none) {
  const auto lines = [](int slivers) {
    ParticlePicture picture = one_polygon(0);
    ParticleFrame& frame = picture.frames[0];
    for (int k = 0; k < slivers; ++k) {
      const double x = 0.6 + 0.1 * k;
      frame.polygons.push_back({{x, 0}, {x + 0.002, 0}, {x + 0.002, 0.1}, {x, 0.1}});
      frame.value.push_back(1);
      frame.shade.push_back(0);
    }
    return decode(png(picture)).at(78 + 350, 18 + 350 + 700.0 / 6) != map_color(ColorMap::viridis, 1);
  };
  EXPECT_TRUE(lines(0));
  EXPECT_FALSE(lines(3));
}

/// x to the right, z upwards, and y, which comes towards whoever looks, not at all; 3 m wide: of 0.2 m.
TEST(ParticlePicture, axes_of_space_stand_in_the_corner) {
  ParticlePicture picture = one_square(0.5);
  picture.x_label = picture.y_label = "";
  const Image without = decode(png(picture));
  picture.space_axes = {{"x", 1, 0}, {"y", 0.01, 0}, {"z", 0, 1}};
  const Image with = decode(png(picture));
  int right = 0, up = 0, beyond = 0;
  for (int y = 18; y < 718; ++y) {
    for (int x = 78; x < 778; ++x) {
      if (with.at(x, y) == without.at(x, y)) continue;
      ++(x < 78 + 140 && y > 718 - 140 ? x > 78 + 60 ? right : up : beyond);
    }
  }
  EXPECT_GT(right, 20);
  EXPECT_GT(up, 40);
  EXPECT_EQ(beyond, 0);
  const double length = 0.2 * 700 / 3;
  int row_of_arrow = 0;  // the longest dark row
  for (int y = 578; y < 718; ++y) {
    int dark = 0;
    for (int x = 78; x < 218; ++x) dark += with.at(x, y).r < 0x60;
    row_of_arrow = std::max(row_of_arrow, dark);
  }
  EXPECT_NEAR(row_of_arrow, length, 10);
}

TEST(ParticlePicture, refuses_what_does_not_fit_together) {
  EXPECT_THROW(png(ParticlePicture{}), std::invalid_argument);
  ParticlePicture picture = one_square(0);
  picture.frames[0].value.push_back(1);
  EXPECT_THROW(png(picture), std::invalid_argument);
}

}  // namespace
}  // namespace assay::drivers::test_particle_picture
