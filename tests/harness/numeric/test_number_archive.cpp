// SPDX-License-Identifier: BSD-3-Clause
#include "harness/numeric/number_archive.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace assay::test_number_archive {
namespace {

enum class Colour { red, green };

struct Part {
  int count = 0;
  std::uint64_t mask = 0;
  std::string text;
};
template <class Archive>
void fields(Archive& archive, Part& part) {
  archive(part.count, part.mask, part.text);
}

struct Whole {
  double value = 0;
  bool flag = false;
  Colour colour = Colour::red;
  Tensor tensor = Tensor::Zero();
  Vector3 vector = Vector3::Zero();
  std::vector<double> numbers;
  std::vector<char> signs;
  std::vector<Part> parts;
};
template <class Archive>
void fields(Archive& archive, Whole& whole) {
  archive(whole.value, whole.flag, whole.colour, whole.tensor, whole.vector, whole.numbers, whole.signs, whole.parts);
}

Whole sample() {
  Whole whole;
  whole.value = -0.0, whole.flag = true, whole.colour = Colour::green;
  whole.tensor << 1, 2, 3, 4, 5, 6, 7, 8, 9;
  whole.vector << -1, 0.5, 1e300;
  whole.numbers = {1e-320, std::numeric_limits<double>::infinity()};
  whole.signs = {1, 0, 1};
  whole.parts = {{-7, ~std::uint64_t{0}, "eightbit"}, {0, 1, ""}, {1, 2, "more than eight"}};
  return whole;
}

std::vector<double> written(Whole whole) {
  NumberWriter writer;
  writer(whole);
  return writer.numbers;
}

TEST(NumberArchive, GivesBackEveryBit) {
  const std::vector<double> numbers = written(sample());
  Whole found;
  NumberReader reader(numbers);
  reader(found);
  EXPECT_TRUE(std::signbit(found.value));
  EXPECT_TRUE(found.flag);
  EXPECT_EQ(found.colour, Colour::green);
  EXPECT_EQ(found.tensor, sample().tensor);
  EXPECT_EQ(found.vector, sample().vector);
  EXPECT_EQ(found.numbers, sample().numbers);
  EXPECT_EQ(found.signs, sample().signs);
  ASSERT_EQ(found.parts.size(), 3u);
  EXPECT_EQ(found.parts[0].count, -7);
  EXPECT_EQ(found.parts[0].mask, ~std::uint64_t{0});
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(found.parts[k].text, sample().parts[k].text);
  EXPECT_EQ(written(found).size(), numbers.size());
}

TEST(NumberArchive, RefusesAListThatIsCut) {
  const std::vector<double> numbers = written(sample());
  for (std::size_t length = 0; length < numbers.size(); ++length) {
    Whole found;
    NumberReader reader(std::span<const double>(numbers).first(length));
    EXPECT_THROW(reader(found), std::runtime_error) << length;
  }
}

TEST(NumberArchive, RefusesSizesThatNoListHas) {
  const std::vector<double> huge(20, std::bit_cast<double>(~std::uint64_t{0} / 2));
  std::vector<double> numbers;
  std::string text;
  std::vector<Part> parts;
  NumberReader reader{std::span<const double>(huge)};
  EXPECT_THROW(reader(numbers), std::runtime_error);
  EXPECT_THROW(reader(text), std::runtime_error);
  EXPECT_THROW(reader(parts), std::runtime_error);
}

}  // namespace
}  // namespace assay::test_number_archive
