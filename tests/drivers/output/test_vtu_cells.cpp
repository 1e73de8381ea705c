// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/output/vtu_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tests/drivers/cells_sample.hpp"
#include "tests/support/vtu_reader.hpp"

namespace assay::drivers::test_vtu_cells {
namespace {

void expect_every_value(std::size_t particles, const std::optional<double>& velocity_t) {
  const std::string text = cells_text(particles, velocity_t);
  const std::string n = std::to_string(particles);
  EXPECT_NE(text.find("<Piece NumberOfPoints=\"" + std::to_string(8 * particles) + "\" NumberOfCells=\"" + n + "\">"),
            text.npos);
  const VtuFile file(text);
  EXPECT_EQ(file.array<double>("Points"), values_of(sample_corners(), particles));
  EXPECT_EQ(file.array<double>("stress"), values_of(sample_array("stress", 9), particles));
  EXPECT_EQ(file.array<double>("shear"), values_of(sample_array("shear", 1), particles));
  std::vector<std::int64_t> counted(8 * particles);
  std::iota(counted.begin(), counted.end(), 0);
  EXPECT_EQ(file.array<std::int64_t>("connectivity"), counted);
  counted.resize(particles);
  EXPECT_EQ(file.array<std::int64_t>("id"), counted);
  for (std::int64_t& end : counted) end = 8 * (end + 1);
  EXPECT_EQ(file.array<std::int64_t>("offsets"), counted);
  EXPECT_EQ(file.array<std::uint8_t>("types"), std::vector<std::uint8_t>(particles, 12));
  EXPECT_EQ(file.array<double>("TimeValue"), std::vector<double>{0.25});
  EXPECT_EQ(text.find("VelocityTime") != text.npos, velocity_t.has_value());
}

TEST(VtuCells, hold_every_value) {
  for (const std::size_t particles : {0, 1, 511, 512, 513, 4096, 40000}) expect_every_value(particles, {});
  expect_every_value(3, 0.2);
  EXPECT_EQ(cells_text(5000), cells_text(5000));
}

/// However many particles there are: one array's part for 4096 of them at a time.
TEST(VtuCells, are_written_in_small_pieces) {
  std::size_t largest = 0, total = 0;
  put_cells(
      [&](std::uint64_t, std::string_view bytes) { largest = std::max(largest, bytes.size()), total += bytes.size(); },
      200000);
  EXPECT_GT(total, 10'000'000u);
  EXPECT_LT(largest, 400'000u);
}

TEST(VtuCells, name_their_components) {
  const VtuFile file(cells_text(2));
  EXPECT_EQ(file.attribute("stress", "ComponentName5"), "23");
  EXPECT_EQ(file.attribute("Points", "ComponentName2"), "z");
}

}  // namespace
}  // namespace assay::drivers::test_vtu_cells
