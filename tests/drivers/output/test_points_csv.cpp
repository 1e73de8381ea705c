// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/output/points_csv.hpp"

#include <gtest/gtest.h>

#include "drivers/system/input_error.hpp"
#include "tests/drivers/scratch_folder.hpp"

namespace assay::drivers::test_points_csv {
namespace {

TEST(PointsCsv, ReadsPointsOfTheSheet) {
  const ScratchFolder scratch;
  const std::vector<SheetPoint> points = read_sheet_points(scratch.write("a.csv", "xi,t\n-3.5,0.25\n0,1\n"));
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[0].xi, -3.5);
  EXPECT_EQ(points[0].t, 0.25);
  EXPECT_THROW(read_sheet_points(scratch.write("b.csv", "X,Y,t\n1,2,3\n")), InputError);
  EXPECT_THROW(read_sheet_points(scratch.write("c.csv", "xi,t\n1,-2\n")), InputError);
}

}  // namespace
}  // namespace assay::drivers::test_points_csv
