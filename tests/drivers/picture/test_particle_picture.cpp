// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/picture/value_pictures.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

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

TEST(ParticlePicture, refuses_what_does_not_fit_together) {
  EXPECT_THROW(png(ParticlePicture{}), std::invalid_argument);
  ParticlePicture picture = one_square(0);
  picture.frames[0].value.push_back(1);
  EXPECT_THROW(png(picture), std::invalid_argument);
}

}  // namespace
}  // namespace assay::drivers::test_particle_picture
