// SPDX-License-Identifier: BSD-3-Clause
#include "harness/motion/kinds/vortex.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace assay::test_vortex {
namespace {

constexpr double step = 1e-5;
/// Central differences: step^2 times third derivatives of a few thousand, relative to values of about ten.
constexpr double difference_error = 1e-6;
/// Second differences lose another 1e-16 / step^2.
constexpr double second_difference_error = 1e-3;

std::vector<Vortex> vortices() {
  return {Vortex{}, Vortex{0.5, 1.6, 3, {Amplitude::Type::one_minus_cosine, 0.4, 0.7}},
          Vortex{0.75, 1.25, 6, {Amplitude::Type::ramp, 2.0, 2.0}}};
}

std::vector<Vector3> points_in(const Vortex& v) {
  std::vector<Vector3> points;
  for (const double s : {0.07, 0.31, 0.5, 0.77, 0.96}) {
    for (const double angle : {0.3, 1.9, 3.0, 4.4, 6.0}) {
      const double R = v.inner + s * (v.outer - v.inner);
      points.emplace_back(R * std::cos(angle), R * std::sin(angle), 0.2);
    }
  }
  return points;
}

TEST(Vortex, VelocityAndAccelerationAreRatesOfThePosition) {
  for (const Vortex& vortex : vortices()) {
    for (const Vector3& X : points_in(vortex)) {
      const double t = 0.23;
      const ExactState state = vortex.at(X, t);
      const Vector3 before = vortex.at(X, t - step).x, after = vortex.at(X, t + step).x;
      EXPECT_LT((state.v - (after - before) / (2 * step)).norm(), difference_error);
      EXPECT_LT((state.a - (after - 2 * state.x + before) / (step * step)).norm(), second_difference_error);
    }
  }
}

TEST(Vortex, DeformationGradientIsTheGradientOfThePosition) {
  for (const Vortex& vortex : vortices()) {
    for (const Vector3& X : points_in(vortex)) {
      const double t = 0.41;
      Tensor differences;
      for (int j = 0; j < 3; ++j) {
        Vector3 shift = Vector3::Zero();
        shift(j) = step;
        differences.col(j) = (vortex.at(X + shift, t).x - vortex.at(X - shift, t).x) / (2 * step);
      }
      const Tensor F = vortex.at(X, t).F;
      EXPECT_LT((F - differences).norm(), difference_error);
      EXPECT_NEAR(F.determinant(), 1, 1e-13);
    }
  }
}

TEST(Vortex, ProfileDerivativesAgreeWithDifferences) {
  for (const Vortex& vortex : vortices()) {
    for (const double s : {0.1, 0.4, 0.6, 0.9}) {
      const double R = vortex.inner + s * (vortex.outer - vortex.inner);
      const auto before = vortex.profile(R - step), here = vortex.profile(R), after = vortex.profile(R + step);
      EXPECT_NEAR(here.h_prime, (after.h - before.h) / (2 * step), difference_error);
      EXPECT_NEAR(here.xi_prime, (after.xi - before.xi) / (2 * step), 100 * difference_error);
      EXPECT_DOUBLE_EQ(here.xi, 0.5 * R * here.h_prime);
    }
  }
}

TEST(Vortex, HasThePapersProfile) {
  for (const double R : {0.75, 0.8, 1.0, 1.13, 1.25}) {
    const double d = R - 1;
    EXPECT_NEAR(Vortex{}.profile(R).h, 1 - 32 * d * d + 256 * d * d * d * d, 1e-13);
  }
}

TEST(Vortex, GivesTheInsideLimitOnItsEdgesAndNothingOutside) {
  const Vortex vortex;
  // h'' = 4 m (m-1) / w^2 = 128 at both edges of the paper's ring, so xi' = R h'' / 2
  EXPECT_NEAR(vortex.profile(0.75).xi_prime, 0.5 * 0.75 * 128, 1e-11);
  EXPECT_NEAR(vortex.profile(1.25).xi_prime, 0.5 * 1.25 * 128, 1e-11);
  EXPECT_EQ(vortex.profile(0.75).h, 0);
  EXPECT_EQ(vortex.profile(0.7499).xi_prime, 0);
  const double on_edge = std::hypot(0.45, 0.6);  // 3-4-5: 0.75 up to rounding
  EXPECT_NE(vortex.profile(on_edge).xi_prime, 0);
  const Vector3 X(0.1, -0.3, 0);
  EXPECT_EQ(vortex.at(X, 0.4).x, X);
  EXPECT_EQ(vortex.at(Vector3::Zero(), 0.4).F, Tensor::Identity());
}

TEST(Vortex, KnowsItsLargestShear) {
  const Vortex vortex;
  const Interval range = vortex.xi_range();
  double lower = 0, upper = 0;
  for (int k = 0; k <= 200000; ++k) {
    const double xi = vortex.profile(0.75 + 0.5 * k / 200000).xi;
    lower = std::min(lower, xi);
    upper = std::max(upper, xi);
  }
  EXPECT_NEAR(range.lower, lower, 1e-8);
  EXPECT_NEAR(range.upper, upper, 1e-8);
  EXPECT_NEAR(-2 * range.lower, 7.07, 0.005);  // the paper's vortex reaches gamma = 7.07
}

TEST(Vortex, BaselineIsTheDeformationWithoutItsRotations) {
  const Vortex vortex;
  const Path path = vortex.baseline();
  for (const Vector3& X : points_in(vortex)) {
    const double t = 0.37, Theta = std::atan2(X.y(), X.x());
    const auto profile = vortex.profile(std::hypot(X.x(), X.y()));
    const double theta = Theta + vortex.amplitude.at(t).value * profile.h;
    const Tensor rebuilt = rotation_about_z(theta) * path.deformation_gradient(profile.xi, t) *
                           rotation_about_z(Theta).transpose();  // (17)
    EXPECT_LT((rebuilt - vortex.at(X, t).F).norm(), 1e-13);
  }
}

}  // namespace
}  // namespace assay::test_vortex
