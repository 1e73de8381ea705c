// SPDX-License-Identifier: BSD-3-Clause
#include "harness/motion/registry.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "harness/motion/kinds/axis_aligned.hpp"
#include "harness/motion/kinds/deformation_table.hpp"
#include "harness/motion/kinds/homogeneous.hpp"
#include "harness/motion/kinds/rigid.hpp"
#include "harness/motion/kinds/rotating_stretch.hpp"
#include "harness/motion/kinds/twisting_ring.hpp"
#include "harness/motion/kinds/vortex.hpp"
#include "harness/motion/motion.hpp"

namespace assay::test_path_recipe {
namespace {

constexpr double end = 2.3;

/// The same bits, wherever it is asked.
void expect_same(const Path& path) {
  ASSERT_FALSE(path.recipe.empty()) << path.name;
  const Path made = path_of_recipe(path.recipe);
  EXPECT_EQ(made.name, path.name);
  EXPECT_EQ(made.recipe, path.recipe);
  EXPECT_EQ(made.straight(), path.straight());
  EXPECT_EQ(made.parameter_is_place, path.parameter_is_place);
  EXPECT_EQ(made.parameter.lower, path.parameter.lower);
  EXPECT_EQ(made.parameter.upper, path.parameter.upper);
  EXPECT_EQ(made.reversals(end), path.reversals(end));
  for (const double share : {0.0, 0.13, 0.5, 0.77, 1.0}) {
    const double xi = path.parameter.lower + share * path.parameter.width();
    for (const double t : {0.0, 0.21, 0.5, 0.9, 1.7}) {
      EXPECT_EQ(made.at(xi, t).F, path.at(xi, t).F) << path.name << " at " << xi << ", " << t;
      EXPECT_EQ(made.at(xi, t).F_rate, path.at(xi, t).F_rate) << path.name << " at " << xi << ", " << t;
    }
  }
}

TEST(PathRecipe, MakesTheSamePathOfEveryMotion) {
  const Vortex vortex{0.7, 1.3, 3, {Amplitude::Type::one_minus_cosine, 0.4, 0.9}};
  expect_same(vortex.baseline());
  expect_same(TwistingRing{vortex, 0.05}.baseline());
  Homogeneous homogeneous;
  homogeneous.final << 1.2, 0.1, 0, 0, 0.9, 0, 0.05, 0, 1;
  homogeneous.period = 0.8;
  expect_same(homogeneous.baseline());
  RotatingStretch stretch;
  stretch.stretch = 0.2, stretch.shear = 0.1, stretch.rotation = 2, stretch.period = 0.7;
  stretch.axis << 1, 2, 3;
  for (const auto rotate :
       {RotatingStretch::Rotate::none, RotatingStretch::Rotate::simultaneous, RotatingStretch::Rotate::after}) {
    stretch.rotate = rotate;
    expect_same(stretch.baseline());
  }
  expect_same(Rigid{Vector3(1, 0, 2), 3, Vector3(0, 1, 1), 0.6}.baseline());
  for (const bool bar : {false, true}) {
    const AxisAligned box{{Amplitude::Type::sine, 0.05, 0.8}, bar, false};
    expect_same(box.baseline());
    expect_same(box.section(0.37));
  }
  const AxisAligned space{{Amplitude::Type::sine, 0.05, 0.8}, false, false, Vector3(0.7, -1.2, 0.4), true};
  expect_same(space.section(0.37, -0.6));
}

TEST(PathRecipe, MakesTheSamePathOfATable) {
  std::vector<double> times;
  std::vector<Tensor> F;
  for (int k = 0; k <= 12; ++k) {
    times.push_back(0.19 * k);
    Tensor row = Tensor::Identity();
    row(0, 1) = 0.3 * std::sin(times.back());
    row(2, 2) = 1 + 0.1 * times.back();
    F.push_back(row);
  }
  for (const Interpolation kind : {Interpolation::linear, Interpolation::monotone, Interpolation::spline}) {
    const DeformationTable table("rows.csv", times, F, kind);
    EXPECT_EQ(table.rows(), F);
    expect_same(table.baseline());
  }
}

TEST(PathRecipe, RefusesWhatIsNone) {
  std::vector<double> recipe = Vortex().baseline().recipe;
  for (std::size_t length = 0; length < recipe.size(); ++length) {
    EXPECT_THROW(path_of_recipe(std::span<const double>(recipe).first(length)), std::runtime_error) << length;
  }
  recipe[0] = 1e300;  // a kind that nothing has
  EXPECT_THROW(path_of_recipe(recipe), std::runtime_error);
}

}  // namespace
}  // namespace assay::test_path_recipe
