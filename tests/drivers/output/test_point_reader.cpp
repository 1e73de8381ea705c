// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/output/point_reader.hpp"

#include <gtest/gtest.h>

#include "drivers/system/input_error.hpp"
#include "tests/drivers/scratch_folder.hpp"

namespace assay::drivers::test_point_reader {
namespace {

class PointReaderTest : public testing::Test {
 protected:
  /// All points, in blocks of so many.
  std::vector<ReferencePoint> points(const std::string& text, const std::vector<double>& times = {},
                                     std::size_t most = 3) {
    const InputBytes input(scratch_.write("p.csv", text));
    PointReader reader(input, times);
    given_ = reader.given();
    std::vector<ReferencePoint> first, second, block;
    while (reader.next(block, most)) first.insert(first.end(), block.begin(), block.end());
    reader.rewind();
    while (reader.next(block, most)) second.insert(second.end(), block.begin(), block.end());
    EXPECT_EQ(first.size(), second.size());
    for (std::size_t k = 0; k < std::min(first.size(), second.size()); ++k) {
      EXPECT_EQ(first[k].X, second[k].X);
      EXPECT_EQ(first[k].t, second[k].t);
    }
    return first;
  }
  std::string refusal(const std::string& text, const std::vector<double>& times = {}) {
    try {
      points(text, times);
    } catch (const InputError& error) {
      const std::string what = error.what(), folder = scratch_ / "";
      return what.starts_with(folder) ? what.substr(folder.size()) : what;
    }
    return "accepted";
  }
  ScratchFolder scratch_;
  PointsGiven given_;
};

TEST_F(PointReaderTest, ReadsPointsWithoutAndWithNormals) {
  const auto plain = points("t,Y,X\n0.5,2,1\n");
  ASSERT_EQ(plain.size(), 1u);
  EXPECT_EQ(plain[0].X, 1);
  EXPECT_EQ(plain[0].Y, 2);
  EXPECT_EQ(plain[0].Z, 0);
  EXPECT_EQ(plain[0].t, 0.5);
  EXPECT_EQ(plain[0].line, 2);
  EXPECT_FALSE(given_.normals);
  EXPECT_FALSE(given_.z);
  const auto full = points("X,Y,Z,t,NX,NY\n1,2,3,4,0,-1\n");
  EXPECT_TRUE(given_.normals);
  EXPECT_TRUE(given_.z);
  EXPECT_EQ(full[0].Z, 3);
  EXPECT_EQ(full[0].NY, -1);
  const auto boxes = points("X,Y,t,HX,HY\n1,2,3,.5,.25\n");
  EXPECT_TRUE(given_.boxes);
  EXPECT_FALSE(given_.third_edge);
  EXPECT_EQ(boxes[0].HZ, .5);
}

TEST_F(PointReaderTest, RefusesHalfANormalAndNone) {
  EXPECT_NE(refusal("X,Y,t,NX\n1,2,3,1\n").find("p.csv:1:1: NX and NY only come together"), std::string::npos);
  EXPECT_NE(refusal("X,Y,t,NX,NY\n1,2,3,0,0\n").find("p.csv:2:1: the normal NX,NY has no length"), std::string::npos);
  EXPECT_NE(refusal("X,Y,Z,t,NX,NY,NZ\n1,2,3,4,0,0,0\n").find("the normal NX,NY,NZ has no length"), std::string::npos);
  EXPECT_NE(refusal("X,Y,t,HX,HY\n1,2,3,0,1\n").find("p.csv:2:1: the half edges"), std::string::npos);
  EXPECT_NE(refusal("X,Y,t\n1,2,3\n1,2,-3\n").find("p.csv:3:1: t: negative"), std::string::npos);
  EXPECT_NE(refusal("X,Y,t\n1,2,3\n1,2,x\n").find("p.csv:3:5: t: 'x' is no finite number"), std::string::npos);
}

TEST_F(PointReaderTest, TimesStandInAColumnOrForAllPoints) {
  const std::string none = refusal("X,Y\n1,2\n");
  EXPECT_NE(none.find("p.csv:1:1: no column 't': each row has its time in a column t, or --times gives"),
            std::string::npos)
      << none;
  EXPECT_NE(refusal("X,Y,t\n1,2,3\n", {0, 1}).find("the points have a column t"), std::string::npos);
  for (const std::size_t most : {1, 2, 3, 4, 100}) {
    const auto found = points("X,Y\n1,0\n2,0\n3,0\n", {0.5, 0, 0.5}, most);
    ASSERT_EQ(found.size(), 9u) << most;
    for (std::size_t k = 0; k < 9; ++k) {
      EXPECT_EQ(found[k].X, static_cast<double>(k % 3 + 1)) << most;
      EXPECT_EQ(found[k].t, k / 3 == 1 ? 0 : 0.5) << most;
      EXPECT_EQ(found[k].line, static_cast<int>(k % 3 + 2)) << most;
    }
  }
}

/// So that a solution is asked for all points of a time at once.
TEST_F(PointReaderTest, ManyPointsOfATimeHaveBlocksOfTheirOwn) {
  std::string text = "X,Y,t\n";
  for (int k = 0; k < 9900; ++k) text += std::to_string(k) + ",0," + std::to_string(k / 3300) + "\n";
  const InputBytes input(scratch_.write("p.csv", text));
  PointReader reader(input);
  std::vector<ReferencePoint> block;
  std::vector<std::size_t> sizes;
  int row = 0;
  while (reader.next(block, 3000)) {
    sizes.push_back(block.size());
    for (const ReferencePoint& point : block) {
      EXPECT_EQ(point.t, block.front().t);
      EXPECT_EQ(point.X, row++);
    }
  }
  EXPECT_EQ(sizes, (std::vector<std::size_t>{3000, 300, 3000, 300, 3000, 300}));
}

/// More than the piece of a file that is held: rows and remarks lie across its ends.
TEST_F(PointReaderTest, ReadsFilesOfAnyLength) {
  constexpr int rows = 120'000;
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    std::string text = "X,Y,t" + end;
    for (int k = 0; k < rows; ++k) {
      if (k % 1000 == 7) text += "# a remark" + end;
      text += std::to_string(k) + (k % 100 == 3 ? ",\"0.25\", 1e0" : ",0.25,1.0") + end;
    }
    ASSERT_GT(text.size(), std::size_t{3} << 19);
    const auto found = points(text, {}, 5000);
    ASSERT_EQ(found.size(), static_cast<std::size_t>(rows));
    int line = 1;
    for (int k = 0; k < rows; ++k) {
      line += k % 1000 == 7 ? 2 : 1;
      const ReferencePoint& point = found[static_cast<std::size_t>(k)];
      ASSERT_EQ(point.X, k);
      ASSERT_EQ(point.line, line);
      ASSERT_EQ(point.Y, 0.25);
      ASSERT_EQ(point.t, 1);
    }
    const std::string last = refusal(text + "1,2" + end);
    EXPECT_NE(last.find("p.csv:" + std::to_string(line + 1) + ":3: 2 fields"), std::string::npos) << last;
  }
}

TEST_F(PointReaderTest, ReadsDecimalCommas) {
  const auto found = points("X;Y;t\n1,5;2;0,25\n3;-4,5;1\n");
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].X, 1.5);
  EXPECT_EQ(found[0].t, 0.25);
  EXPECT_EQ(found[1].Y, -4.5);
  EXPECT_NE(refusal("X;Y;t\n1.5;2;0.25\n3;-4,5;1\n").find(":3:3: Y: '-4,5': a decimal comma and a decimal point"),
            std::string::npos);
}

}  // namespace
}  // namespace assay::drivers::test_point_reader
