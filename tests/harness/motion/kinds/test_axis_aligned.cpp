// SPDX-License-Identifier: BSD-3-Clause
#include "harness/motion/kinds/axis_aligned.hpp"

#include <gtest/gtest.h>

#include "harness/motion/motion.hpp"
#include "harness/numeric/central_difference.hpp"

namespace assay::test_axis_aligned {
namespace {

const AxisAligned plane{{Amplitude::Type::sine, 0.1, 0.8}, false, true};
const AxisAligned bar{{Amplitude::Type::sine, 0.1, 0.8}, true, true};
const AxisAligned space{{Amplitude::Type::sine, 0.1, 0.8}, false, true, {}, true};
const AxisAligned chosen{{Amplitude::Type::sine, 0.1, 0.8}, false, true, Vector3(0.7, 0, -1.2), true};
const Vector3 somewhere(0.3, 0.7, 1.15);
constexpr double rounding = 1e-14;

TEST(AxisAligned, HasAFactorForEachAxis) {
  EXPECT_EQ(plane.s(), Vector3(1, -1, 0));
  EXPECT_EQ(bar.s(), Vector3(1, 0, 0));
  EXPECT_EQ(space.s(), Vector3(1, -1, 0.5));
  EXPECT_EQ(chosen.s(), Vector3(0.7, 0, -1.2));
  Motion told = plane;
  told->set_dimension(3);
  EXPECT_EQ(told.as<AxisAligned>()->s(), space.s());
}

TEST(AxisAligned, TheFactorsOfTheThirdAxisLeaveTheOthersAlone) {
  const ExactState in_plane = plane.at(somewhere, 0.3), in_space = space.at(somewhere, 0.3);
  EXPECT_EQ(in_space.x.head<2>(), in_plane.x.head<2>());
  EXPECT_EQ(in_space.a.head<2>(), in_plane.a.head<2>());
  EXPECT_EQ(in_plane.x.z(), somewhere.z());
  EXPECT_NE(in_space.x.z(), somewhere.z());
}

TEST(AxisAligned, KnowsTheGradientOfItsAcceleration) {
  constexpr double step = 1e-2, of_differences = 1e-11;
  for (const AxisAligned& motion : {plane, bar, space, chosen}) {
    Tensor gradient;
    for (int d = 0; d < 3; ++d) {
      gradient.col(d) =
          central_difference([&](int k) { return motion.at(somewhere + k * step * Vector3::Unit(d), 0.3).a; }, step);
    }
    EXPECT_LT((motion.acceleration_gradient(somewhere, 0.3) - gradient).norm(), of_differences);
  }
}

/// Along each axis: the mirror image at whole metres, and the same again after two.
TEST(AxisAligned, HasSymmetryPlanesAndRepeats) {
  for (const AxisAligned& motion : {plane, bar, space, chosen}) {
    const Motion kind = motion;
    for (int d = 0; d < 3; ++d) {
      const auto axis = static_cast<std::size_t>(d);
      const bool still = motion.s()(d) == 0;
      for (const double at : {-1.0, 0.0, 1.0, 3.0}) {
        EXPECT_TRUE(kind->is_symmetry_plane(axis, at));
        Vector3 image = somewhere;
        image(d) = 2 * at - somewhere(d);
        Vector3 mirrored = motion.at(somewhere, 0.3).v;
        mirrored(d) *= -1;
        EXPECT_LT((motion.at(image, 0.3).v - mirrored).norm(), rounding);
      }
      EXPECT_EQ(kind->is_symmetry_plane(axis, 0.4), still);
      EXPECT_EQ(kind->fault_of_period(axis, 2), "");
      EXPECT_EQ(kind->fault_of_period(axis, 1).empty(), still);
      EXPECT_LT((motion.at(somewhere + 2 * Vector3::Unit(d), 0.3).v - motion.at(somewhere, 0.3).v).norm(), rounding);
    }
  }
}

TEST(AxisAligned, LeavesThePlaneWithAThirdFactor) {
  EXPECT_TRUE(Motion(plane)->is_plane() && Motion(bar)->is_plane());
  EXPECT_FALSE(Motion(space)->is_plane());
  EXPECT_TRUE(Motion(space)->is_spatial());
  EXPECT_FALSE(Motion(space)->fault({.gives = {}, .dimension = 3}));
  EXPECT_EQ(Motion(space)->fault({.gives = {}, .dimension = 2})->key, "motion.factors");
}

TEST(AxisAligned, TheLargestFactorBoundsThePeak) {
  AxisAligned motion = chosen;
  motion.amplitude.peak = 0.265;  // 1/pi over 1.2
  EXPECT_FALSE(Motion(motion)->fault({.gives = {}, .dimension = 3}));
  motion.amplitude.peak = -0.266;
  EXPECT_EQ(Motion(motion)->fault({.gives = {}, .dimension = 3})->key, "motion.amplitude.peak");
}

}  // namespace
}  // namespace assay::test_axis_aligned
