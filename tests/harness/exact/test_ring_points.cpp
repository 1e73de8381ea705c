// SPDX-License-Identifier: BSD-3-Clause
#include "harness/exact/polar.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace assay::test_ring_points {
namespace {

TEST(RingPoints, PointsOfOneCircleShareARadiusWhateverTheirRounding) {
  std::vector<double> X, Y;
  for (int ring = 0; ring < 5; ++ring) {
    for (int k = 0; k < 1000; ++k) {
      const double R = 0.8 + 0.05 * ring, angle = 0.0061 * k;
      X.push_back(R * std::cos(angle)), Y.push_back(R * std::sin(angle));
    }
  }
  const RingPoints points(X, Y);
  ASSERT_EQ(points.radius.size(), 5u);
  for (std::size_t i = 0; i < X.size(); ++i) {
    EXPECT_EQ(points.ring[i], i / 1000);
    EXPECT_NEAR(points.radius[points.ring[i]], std::hypot(X[i], Y[i]), 1e-14);
    EXPECT_NEAR(points.cos_theta[i] * points.cos_theta[i] + points.sin_theta[i] * points.sin_theta[i], 1, 1e-14);
  }
}

TEST(RingPoints, DifferentRadiiStayApartAlsoWhereTheyAreClose) {
  const std::vector<double> X{1, 1 + 1e-12, 0, 1}, Y{0, 0, 0, 1e-3};
  const RingPoints points(X, Y);
  ASSERT_EQ(points.radius.size(), 4u);
  EXPECT_EQ(points.ring, (std::vector<std::uint32_t>{1, 2, 0, 3}));
  EXPECT_EQ(points.cos_theta[2], 1);  // the origin has an angle too
}

}  // namespace
}  // namespace assay::test_ring_points
