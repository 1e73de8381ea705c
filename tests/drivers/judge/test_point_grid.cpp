// SPDX-License-Identifier: BSD-3-Clause
// The nearest point of a grid of boxes is that of all points.
#include "drivers/judge/point_grid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace assay::drivers::test_point_grid {
namespace {

std::uint32_t nearest_of_all(const std::vector<Vector3>& points, const Vector3& at) {
  std::uint32_t best = 0;
  double least = HUGE_VAL;
  for (std::uint32_t k = 0; k < points.size(); ++k) {
    if (const double distance = (points[k] - at).squaredNorm(); distance < least) least = distance, best = k;
  }
  return best;
}

class PointGrids : public testing::TestWithParam<int> {};

TEST_P(PointGrids, FindTheNearestPoint) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto somewhere = [&] {
    return Vector3(uniform(random), uniform(random), GetParam() == 3 ? uniform(random) : 0);
  };
  std::vector<Vector3> points;
  for (int k = 0; k < 3000; ++k) points.push_back(somewhere());
  points[7] = Vector3::Constant(std::nan(""));
  points[8] = Vector3(1e30, 0, 0);
  const double apart = GetParam() == 3 ? 0.15 : 0.04;  // about
  const PointGrid grid(points, 2 * apart);
  for (int k = 0; k < 500; ++k) {
    const Vector3 at = somewhere();
    EXPECT_EQ(grid.nearest(at), nearest_of_all(points, at));
  }
  for (std::uint32_t k = 0; k < points.size(); k += 17) EXPECT_EQ(grid.nearest(points[k]), k);
}

TEST_P(PointGrids, FindNoneFarAway) {
  const std::vector<Vector3> two{Vector3::Zero(), Vector3::Ones()}, none;
  EXPECT_FALSE(PointGrid(two, 0.5).nearest(Vector3(40, 0, 0)));
  EXPECT_FALSE(PointGrid(none, 1).nearest(Vector3::Zero()));
}

INSTANTIATE_TEST_SUITE_P(Dimensions, PointGrids, testing::Values(2, 3));

}  // namespace
}  // namespace assay::drivers::test_point_grid
