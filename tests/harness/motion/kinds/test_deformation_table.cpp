// SPDX-License-Identifier: BSD-3-Clause
#include "harness/motion/kinds/deformation_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "harness/motion/motion.hpp"

namespace assay::test_deformation_table {
namespace {

Tensor gradient(double t) {
  Tensor F;
  F << 1 + 0.3 * t, 0.2 * t * t, 0, -0.4 * t * t * t, 1 - 0.1 * t, 0.1 * t, 0, 0, 1 + 0.2 * t * t;
  return F;
}

DeformationTable sampled(const std::function<Tensor(double)>& F, double end, int rows,
                         Interpolation kind = Interpolation::spline) {
  std::vector<double> times;
  std::vector<Tensor> values;
  for (int i = 0; i < rows; ++i) {
    times.push_back(end * i / (rows - 1));
    values.push_back(F(times.back()));
  }
  return {"path.csv", times, values, kind};
}

TEST(DeformationTable, GoesThroughItsRowsWithTheirVelocityAndAcceleration) {
  const DeformationTable table = sampled(gradient, 1.2, 7);
  const Vector3 X(1, -2, 0.5);
  for (const double t : {0.0, 0.1, 0.77, 1.2}) {
    const ExactState state = table.at(X, t);
    Tensor rate, acceleration;
    rate << 0.3, 0.4 * t, 0, -1.2 * t * t, -0.1, 0.1, 0, 0, 0.4 * t;
    acceleration << 0, 0.4, 0, -2.4 * t, 0, 0, 0, 0, 0.4;
    EXPECT_LT((state.F - gradient(t)).norm(), 1e-14);
    EXPECT_LT((state.v - rate * X).norm(), 1e-13);
    EXPECT_LT((state.a - acceleration * X).norm(), 1e-11);
    EXPECT_LT((table.baseline().at(0.5, t).F_rate - 0.5 * rate).norm(), 1e-13);
    EXPECT_LT((table.baseline().at(1, t).F - gradient(t)).norm(), 1e-14);
  }
  EXPECT_EQ(Motion(table)->period(), 1.2);
  EXPECT_FALSE(table.plane());
  EXPECT_EQ(table.baseline().reversals(0.5).size(), 2u);
  EXPECT_DOUBLE_EQ(table.baseline().reversals(0.5)[1], 0.4);
}

TEST(DeformationTable, TheFamilyStaysAwayFromSingularDeformation) {
  EXPECT_EQ(sampled(gradient, 1, 9).baseline().parameter.lower, 0);
  // a rotation by 180 degrees: on the straight line from I to it det F falls to 0
  const auto turning = [](double t) { return rotation_about_z(std::numbers::pi * t); };
  const Path path = sampled(turning, 1, 21).baseline();
  EXPECT_GT(path.parameter.lower, 0.5);
  EXPECT_LT(path.parameter.lower, 1);
  for (int i = 0; i <= 40; ++i) {
    for (int k = 0; k <= 40; ++k) {
      const double xi = path.parameter.lower + path.parameter.width() * i / 40;
      EXPECT_GT(path.deformation_gradient(xi, k / 40.0).determinant(), 0.2);
    }
  }
}

TEST(DeformationTable, FindsTheSmallestDeterminantBetweenRows) {
  const DeformationTable table(
      "p", std::vector{0.0, 1.0, 2.0, 3.0},
      std::vector<Tensor>{Tensor::Identity(), 0.2 * Tensor::Identity(), 0.2 * Tensor::Identity(), Tensor::Identity()},
      Interpolation::spline);
  const auto worst = table.smallest_determinant();
  EXPECT_LT(worst.value, 0.2 * 0.2 * 0.2);
  EXPECT_EQ(worst.row, 1u);
  EXPECT_NEAR(worst.t, 1.5, 0.05);
  EXPECT_NEAR(table.interpolated(Interpolation::monotone).smallest_determinant().value, 0.2 * 0.2 * 0.2, 1e-16);
}

/// F11 stretched and held, F12 a triangle, F21 on unequal steps.
DeformationTable with_held_rows(Interpolation kind) {
  std::vector<Tensor> F(5, Tensor::Identity());
  for (std::size_t k = 1; k < F.size(); ++k) F[k](0, 0) = 1.05;
  F[2](0, 1) = 0.001;
  F[4](1, 0) = -0.002;
  return {"held.csv", std::vector{0.0, 0.1, 0.2, 0.6, 1.0}, F, kind};
}

TEST(DeformationTable, HeldRowsStayHeldUnlessASplineIsAskedFor) {
  for (const Interpolation kind : {Interpolation::linear, Interpolation::monotone}) {
    const DeformationTable table = with_held_rows(kind);
    for (int k = 0; k <= 90; ++k) {
      const ExactState state = table.at({1, 1, 1}, 0.1 + k * 0.01);
      EXPECT_EQ(state.F(0, 0), 1.05);
      EXPECT_EQ(state.F_rate(0, 0), 0);
    }
    EXPECT_FALSE(table.farthest_departure()) << static_cast<int>(kind);
  }
  const auto far = with_held_rows(Interpolation::spline).farthest_departure();
  ASSERT_TRUE(far);
  EXPECT_EQ(far->component, 0);
  EXPECT_EQ(far->upper, 1.05);
  EXPECT_GT(far->by, 0.002);
}

/// Steps of a history end on rows, and F' behind a row is not that before it.
TEST(DeformationTable, AStraightPieceHasOneRate) {
  const DeformationTable table = with_held_rows(Interpolation::linear);
  const Path path = table.baseline();
  EXPECT_EQ(path.reversals(1), (std::vector{0.1, 0.2, 0.6}));
  EXPECT_DOUBLE_EQ(path.at(1, 0.05).F_rate(0, 0), 0.5);
  EXPECT_DOUBLE_EQ(path.at(1, 0.1 - 1e-12).F_rate(0, 0), 0.5);
  EXPECT_EQ(path.at(1, 0.1).F_rate(0, 0), 0);
  EXPECT_DOUBLE_EQ(path.at(1, 0.1).F_rate(0, 1), 0.01);
  EXPECT_DOUBLE_EQ(path.at(1, 0.4).F_rate(0, 1), -0.0025);
}

}  // namespace
}  // namespace assay::test_deformation_table
