// SPDX-License-Identifier: BSD-3-Clause
#include "harness/motion/kinds/homogeneous.hpp"

#include <gtest/gtest.h>

#include "harness/motion/kinds/vortex.hpp"
#include "harness/motion/motion.hpp"

namespace assay::test_homogeneous {
namespace {

TEST(Homogeneous, MorphsLinearly) {
  Homogeneous motion;
  motion.final << 1.4, 0.2, 0, -0.1, 0.8, 0.3, 0, 0, 1.1;
  motion.period = 2;
  const Vector3 X(0.3, -0.7, 0.5);
  const ExactState half = motion.at(X, 1);
  EXPECT_LT((half.F - 0.5 * (Tensor::Identity() + motion.final)).norm(), 1e-15);
  EXPECT_LT((half.x - half.F * X).norm(), 1e-15);
  EXPECT_LT((half.v - (motion.at(X, 1.5).x - motion.at(X, 0.5).x)).norm(), 1e-15);
  EXPECT_EQ(half.a, Vector3::Zero());
  EXPECT_EQ(motion.at(X, 0).x, X);
}

TEST(Homogeneous, BaselineHasTheScenesOwnPathInIt) {
  Homogeneous general, stretch, compression;
  general.final << 1.4, 0.2, 0, -0.1, 0.8, 0, 0, 0, 1;
  stretch.final(0, 0) = 2.5;
  compression.final(0, 0) = 0.4;
  for (const Homogeneous& motion : {general, stretch, compression}) {
    const Path path = motion.baseline();
    const double own = motion.own_parameter();
    EXPECT_GE(own, path.parameter.lower);
    EXPECT_LE(own, path.parameter.upper);
    for (const double t : {0.0, 0.3, 1.0}) {
      EXPECT_LT((path.deformation_gradient(own, t) - motion.at(Vector3::Zero(), t).F).norm(), 1e-15);
    }
  }
  EXPECT_EQ(general.baseline().name, "straight");
  EXPECT_EQ(stretch.baseline().name, "uniaxial_strain");
  EXPECT_EQ(compression.own_parameter(), 0.4 - 1);
}

TEST(Motion, KnowsItsPeriod) {
  EXPECT_EQ(Motion(Vortex{0.75, 1.25, 2, {Amplitude::Type::sine, 1, 3}})->period(), 3);
  EXPECT_EQ(Motion(Homogeneous{Tensor::Identity(), 4})->period(), 4);
}

}  // namespace
}  // namespace assay::test_homogeneous
