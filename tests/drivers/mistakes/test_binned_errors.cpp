// SPDX-License-Identifier: BSD-3-Clause
// Means of errors over parts of a body, and how they go around a ring.
#include "drivers/mistakes/binned_errors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "harness/motion/kinds/homogeneous.hpp"
#include "harness/motion/kinds/vortex.hpp"

namespace assay::drivers::test_binned_errors {
namespace {

constexpr double exactly = 1e-12;

/// 64 particles around, on four radii, turned by 0.3; error: of the angle Theta.
BinnedErrors ring_with(const std::function<Vector3(double theta)>& error) {
  BinnedErrors errors(Vortex(), {-1.5, -1.5}, {1.5, 1.5});
  errors.begin_frame(0.5);
  for (const double R : {0.8, 0.95, 1.05, 1.2}) {
    for (int k = 0; k < 64; ++k) {
      const double theta = 2 * M_PI * k / 64;
      const Vector3 X(R * std::cos(theta), R * std::sin(theta), 0), x = rotation_about_z(0.3) * X;
      errors.add(X, error(theta), x, 2);
    }
  }
  errors.finish();
  return errors;
}

TEST(BinnedErrors, OfARingAreTurnedBack) {
  const BinnedErrors errors = ring_with([](double theta) {
    return Vector3(0.1 * std::cos(theta + 0.3), 0.1 * std::sin(theta + 0.3), 0);  // along e_r
  });
  double weight = 0;
  for (std::size_t b = 0; b < errors.X.size(); ++b) {
    weight += errors.weight[b];
    if (errors.weight[b] == 0) continue;
    EXPECT_NEAR(errors.e[0][b].x(), 0.1, exactly);
    EXPECT_NEAR(errors.e[0][b].y(), 0, exactly);
  }
  EXPECT_NEAR(weight, 1, exactly);
  EXPECT_NEAR(errors.square[0], 0.01, exactly);
  EXPECT_NEAR(errors.of_wave[0][0], 0.01, exactly);
}

TEST(BinnedErrors, AShiftedOriginMakesOneWave) {
  const BinnedErrors errors = ring_with([](double) { return Vector3(0.02, 0.01, 0); });
  EXPECT_NEAR(errors.of_wave[0][1], errors.square[0], exactly);
  EXPECT_NEAR(errors.of_wave[0][0], 0, exactly);
}

TEST(BinnedErrors, ASquareLatticeMakesFour) {
  const BinnedErrors errors = ring_with([](double theta) {
    return Vector3(std::cos(4 * theta) * Vector3(-std::sin(theta + 0.3), std::cos(theta + 0.3), 0));
  });
  EXPECT_NEAR(errors.of_wave[0][4], errors.square[0], exactly);
}

TEST(BinnedErrors, OfABoxAreAlongTheAxes) {
  BinnedErrors errors(Homogeneous(), {0, 0}, {3, 3});
  for (const double t : {0.0, 1.0}) {
    errors.begin_frame(t);
    errors.add({0.2, 0.2, 0}, {t, 2 * t, 0}, {0.3, 0.2, 0}, 1);
    errors.add({2.9, 2.9, 0}, {-t, 0, 0}, {2.9, 2.9, 0}, 3);
  }
  errors.finish();
  EXPECT_EQ(errors.e[1].front(), Vector3(1, 2, 0));
  EXPECT_EQ(errors.e[1].back(), Vector3(-1, 0, 0));
  EXPECT_EQ(errors.weight.front(), 0.25);
  EXPECT_NEAR(errors.square[1], 0.25 * 5 + 0.75, exactly);
  EXPECT_NEAR(errors.motion[1], 0.25 * 0.01, exactly);
}

}  // namespace
}  // namespace assay::drivers::test_binned_errors
