// SPDX-License-Identifier: BSD-3-Clause
// What every motion must be, whatever its formulas: rates are those of the position, F is its gradient.
#include <gtest/gtest.h>

#include <cmath>

#include "harness/motion/kinds/axis_aligned.hpp"
#include "harness/motion/kinds/vortex3d.hpp"
#include "tests/harness/motion/all_motions.hpp"

namespace assay::test_motion {
namespace {

constexpr double difference_step = 1e-4;  ///< [m], [s]; central differences of fourth order leave rounding / step
constexpr double close = 2e-9;            ///< of first differences of fields of size 1 to 10
constexpr double close_twice = 2e-7;      ///< of differences of rates, which are larger

const std::vector<Vector3> places{{0.8, 0.31, 0.2}, {-0.53, 0.77, -0.4}, {0.6, -0.75, 0}};
const std::vector<double> times{0.17, 0.61, 0.93};

/// (f(-2) - 8 f(-1) + 8 f(1) - f(2)) / 12 step.
template <class Function>
auto slope(const Function& f, double h = difference_step) {
  return ((f(-2 * h) - 8 * f(-h) + 8 * f(h) - f(2 * h)) / (12 * h)).eval();
}

TEST(Motion, VelocityAndAccelerationAreRatesOfThePosition) {
  for (const auto& [name, motion] : all_motions()) {
    for (const Vector3& X : places) {
      for (const double t : times) {
        const ExactState now = motion->at(X, t);
        const auto x = [&, &motion = motion](double dt) { return motion->at(X, t + dt).x; };
        const auto v = [&, &motion = motion](double dt) { return motion->at(X, t + dt).v; };
        EXPECT_LT((slope(x) - now.v).norm(), close) << name;
        EXPECT_LT((slope(v) - now.a).norm(), close_twice) << name;
      }
    }
  }
}

TEST(Motion, DeformationGradientAndItsRateAreGradients) {
  for (const auto& [name, motion] : all_motions()) {
    for (const Vector3& X : places) {
      for (const double t : times) {
        const ExactState now = motion->at(X, t);
        for (int d = 0; d < 3; ++d) {
          const auto x = [&, &motion = motion](double h) { return motion->at(X + h * Vector3::Unit(d), t).x; };
          const auto v = [&, &motion = motion](double h) { return motion->at(X + h * Vector3::Unit(d), t).v; };
          EXPECT_LT((slope(x) - now.F.col(d)).norm(), close) << name << d;
          EXPECT_LT((slope(v) - now.F_rate.col(d)).norm(), close_twice) << name << d;
        }
      }
    }
  }
}

TEST(Motion, BeginsUndeformed) {
  for (const auto& [name, motion] : all_motions()) {
    const ExactState state = motion->at(places[0], 0);
    EXPECT_LT((state.F - Tensor::Identity()).norm(), 1e-15) << name;
    EXPECT_LT((state.x - places[0]).norm(), 1e-15) << name;
  }
}

/// The baseline is F without the rotations that stand beside it: the same C = F^T F in the baseline's frame.
TEST(Motion, BaselineStretchesAsTheMotionDoes) {
  for (const auto& [name, motion] : all_motions()) {
    const Vector3& X = places[1];
    for (const double t : times) {
      const double R = std::hypot(X.x(), X.y());
      double parameter = ring_of(motion) ? ring_parameter(motion, R).value : motion->own_parameter();
      Path path = motion->baseline();
      if (const auto* box = motion.as<AxisAligned>()) {
        parameter = std::cos(M_PI * X.x());
        path = box->section(std::cos(M_PI * X.y()), std::cos(M_PI * X.z()));
      }
      Tensor q = ring_of(motion) ? rotation_about_z(std::atan2(X.y(), X.x())) : Tensor(Tensor::Identity());
      if (const auto* vortex = motion.as<Vortex3d>()) {
        const auto point = vortex->place(X);
        parameter = point ? point->xi : 0;
        if (point) q = point->axes();
      }
      const Tensor F = motion->at(X, t).F * q, B = path.deformation_gradient(parameter, t);
      EXPECT_LT((F.transpose() * F - B.transpose() * B).norm(), 1e-13) << name;
      const double h = difference_step;
      const auto of_t = [&](double dt) { return path.deformation_gradient(parameter, t + dt); };
      EXPECT_LT((slope(of_t, h) - path.at(parameter, t).F_rate).norm(), close) << name;
    }
  }
}

TEST(Motion, KnowsWhatItHas) {
  for (const auto& [who, motion] : chosen_motions()) {
    EXPECT_EQ(ring_of(motion).has_value(), who == "vortex" || who == "twisting_ring") << who;
    EXPECT_EQ(motion->amplitude() != nullptr,
              who.starts_with("vortex") || who == "twisting_ring" || who.starts_with("axis_aligned") || who == "bar_1d")
        << who;
  }
  for (const auto& [who, motion] : all_motions()) {
    EXPECT_GT(motion->period(), 0) << who;
    const Tensor here = motion->at(places[0], 0.4).F, there = motion->at(places[1], 0.4).F;
    EXPECT_EQ(motion->is_homogeneous(), here == there) << who;
  }
}

}  // namespace
}  // namespace assay::test_motion
