// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/output/points_csv.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "drivers/system/input_error.hpp"

namespace assay::drivers::test_points_csv {
namespace {

class PointsCsvTest : public testing::Test {
 protected:
  std::string file(const std::string& text) {
    path_ = std::filesystem::temp_directory_path() / ("assay_points_" + std::to_string(::getpid()) + ".csv");
    std::ofstream(path_, std::ios::binary) << text;
    return path_.string();
  }
  void TearDown() override { std::filesystem::remove(path_); }
  std::filesystem::path path_;
};

TEST_F(PointsCsvTest, reads_points_without_and_with_normals) {
  const ReferencePoints plain = read_reference_points(file("t,Y,X\n0.5,2,1\n"));
  ASSERT_EQ(plain.points.size(), 1u);
  EXPECT_EQ(plain.points[0].X, 1);
  EXPECT_EQ(plain.points[0].Y, 2);
  EXPECT_EQ(plain.points[0].Z, 0);
  EXPECT_EQ(plain.points[0].t, 0.5);
  EXPECT_FALSE(plain.has_normals);
  EXPECT_FALSE(plain.has_z);
  const ReferencePoints full = read_reference_points(file("X,Y,Z,t,NX,NY\n1,2,3,4,0,-1\n"));
  EXPECT_TRUE(full.has_normals);
  EXPECT_TRUE(full.has_z);
  EXPECT_EQ(full.points[0].Z, 3);
  EXPECT_EQ(full.points[0].NY, -1);
}

TEST_F(PointsCsvTest, refuses_half_a_normal_and_none) {
  EXPECT_THROW(read_reference_points(file("X,Y,t,NX\n1,2,3,1\n")), InputError);
  EXPECT_THROW(read_reference_points(file("X,Y,t,NX,NY\n1,2,3,0,0\n")), InputError);
  EXPECT_THROW(read_reference_points(file("X,Y\n1,2\n")), InputError);
  const auto refusal = [&](const char* text) -> std::string {
    try {
      read_reference_points(file(text));
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_TRUE(refusal("X,Y,t,NX,NY\n1,2,3,0,0\n").ends_with("the normal NX,NY has no length"));
  EXPECT_TRUE(refusal("X,Y,Z,t,NX,NY,NZ\n1,2,3,4,0,0,0\n").ends_with("the normal NX,NY,NZ has no length"));
}

TEST_F(PointsCsvTest, reads_points_of_the_sheet) {
  const std::vector<SheetPoint> points = read_sheet_points(file("xi,t\n-3.5,0.25\n0,1\n"));
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[0].xi, -3.5);
  EXPECT_EQ(points[0].t, 0.25);
  EXPECT_THROW(read_sheet_points(file("X,Y,t\n1,2,3\n")), InputError);
}

}  // namespace
}  // namespace assay::drivers::test_points_csv
