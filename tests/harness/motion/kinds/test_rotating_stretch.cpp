// SPDX-License-Identifier: BSD-3-Clause
#include "harness/motion/kinds/rotating_stretch.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "harness/motion/kinds/rigid.hpp"
#include "harness/motion/motion.hpp"

namespace assay::test_rotating_stretch {
namespace {

using std::numbers::pi;
using Rotate = RotatingStretch::Rotate;

RotatingStretch sample(Rotate rotate) {
  RotatingStretch m;
  m.stretch = 0.3;
  m.shear = -0.7;
  m.rotation = 1.9;
  m.axis = {1, 2, 3};
  m.rotate = rotate;
  m.period = 1.7;
  return m;
}

double q(double u) {
  u = std::min(std::max(u, 0.0), 1.0);
  return std::pow(u, 3) * (10 - 15 * u + 6 * u * u);
}

/// The motion's definition, written once more.
Tensor expected(const RotatingStretch& m, double t) {
  const double u = t / m.period;
  const bool after = m.rotate == Rotate::after;
  const double stretch = 1 + m.stretch * (after ? q(std::min(2 * u, 1.0)) : std::pow(std::sin(pi * u), 2));
  const double angle = m.rotate == Rotate::none ? 0 : m.rotation * (after ? q(2 * u - 1) : q(u));
  Tensor U = Tensor::Identity();
  U(0, 0) = stretch;
  U(0, 1) = m.shear * (stretch - 1) / m.stretch;
  return Eigen::AngleAxisd(angle, m.axis.normalized()).toRotationMatrix() * U;
}

TEST(RotatingStretch, IsItsDefinition) {
  for (const Rotate rotate : {Rotate::none, Rotate::simultaneous, Rotate::after}) {
    const RotatingStretch m = sample(rotate);
    for (const double u : {0.0, 0.11, 0.5, 0.63, 0.9, 1.0, 1.4}) {
      const double t = u * m.period;
      EXPECT_LT((m.at(Vector3::Zero(), t).F - expected(m, t)).norm(), 1e-14) << u;
      EXPECT_LT((m.baseline().deformation_gradient(1, t) - expected(m, t)).norm(), 1e-14) << u;
    }
  }
}

/// Squares of these lengths vanish or overflow, of the last one the length itself.
TEST(RotatingStretch, AnAxisMayBeOfAnyLength) {
  RotatingStretch m = sample(Rotate::after), other = m;
  m.axis = {1, 1, 0};
  for (const double length : {1e-170, 1e160, 1.7e308}) {
    other.axis = length * m.axis;
    EXPECT_LT((other.at({1, 2, 3}, 1.4).F - m.at({1, 2, 3}, 1.4).F).norm(), 1e-14) << length;
    const Rigid one{{0, 0, 0}, 1.7, m.axis, 1}, same{{0, 0, 0}, 1.7, other.axis, 1};
    EXPECT_LT((same.at({1, 2, 3}, 1.4).F - one.at({1, 2, 3}, 1.4).F).norm(), 1e-14) << length;
  }
}

TEST(RotatingStretch, VelocityAndAccelerationAreThoseOfThePosition) {
  const Vector3 X(0.3, -1.1, 0.8);
  for (const Rotate rotate : {Rotate::none, Rotate::simultaneous, Rotate::after}) {
    const RotatingStretch m = sample(rotate);
    for (const double u : {0.07, 0.23, 0.41, 0.66, 0.94, 1.3}) {
      const double t = u * m.period, h = 1e-3;
      const auto x = [&](double s) { return m.at(X, t + s).x; };
      const Vector3 v = (8 * (x(h) - x(-h)) - (x(2 * h) - x(-2 * h))) / (12 * h);
      const Vector3 a = (16 * (x(h) + x(-h)) - (x(2 * h) + x(-2 * h)) - 30 * x(0)) / (12 * h * h);
      EXPECT_LT((m.at(X, t).v - v).norm(), 1e-8) << u;
      EXPECT_LT((m.at(X, t).a - a).norm(), 1e-6) << u;
      const Path path = m.baseline();
      const Tensor rate = (8 * (path.deformation_gradient(0.4, t + h) - path.deformation_gradient(0.4, t - h)) -
                           (path.deformation_gradient(0.4, t + 2 * h) - path.deformation_gradient(0.4, t - 2 * h))) /
                          (12 * h);
      EXPECT_LT((path.at(0.4, t).F_rate - rate).norm(), 1e-8) << u;
    }
  }
}

TEST(RotatingStretch, TheParameterScalesTheStretchAndNotTheRotation) {
  const RotatingStretch m = sample(Rotate::simultaneous);
  RotatingStretch weaker = m;
  weaker.stretch *= 0.25;
  weaker.shear *= 0.25;  // (Lambda - 1)/a is the same in both
  const double t = 0.8;
  EXPECT_LT((m.baseline().deformation_gradient(0.25, t) - weaker.at(Vector3::Zero(), t).F).norm(), 1e-15);
  const Tensor Q = m.baseline().deformation_gradient(0, t);
  EXPECT_LT((Q * Q.transpose() - Tensor::Identity()).norm(), 1e-14);
}

TEST(RotatingStretch, TurnsAtTheMultiplesOfHalfThePeriod) {
  EXPECT_EQ(sample(Rotate::none).baseline().reversals(3), (std::vector<double>{0.85, 1.7, 0.5 * 1.7 * 3}));
  EXPECT_EQ(sample(Rotate::after).baseline().reversals(9), (std::vector<double>{0.85, 1.7}));
  EXPECT_TRUE(sample(Rotate::after).baseline().reversals(0.85).empty());
  EXPECT_EQ(Motion(sample(Rotate::after))->period(), 1.7);
}

}  // namespace
}  // namespace assay::test_rotating_stretch
