// SPDX-License-Identifier: BSD-3-Clause
#include "harness/motion/kinds/vortex3d.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "harness/motion/motion.hpp"
#include "harness/motion/registry.hpp"

namespace assay::test_vortex3d {
namespace {

constexpr double rounding = 1e-13;

Revolution torus(double R0, double w, int power) {
  return {.profile = Revolution::Profile::torus, .radius = w, .ring_radius = R0, .profile_power = power};
}

Revolution drum(double c, int power) {
  return {.profile = Revolution::Profile::drum, .height = c, .profile_power = power, .height_power = power};
}

/// gamma_max/A = 2 xi_max, three digits, of an independent derivation.
TEST(Vortex3d, TheLargestShearIsThatOfTheTable) {
  struct Row {
    Revolution shape;
    double gamma;
    double digits;
  };
  const Row rows[] = {
      {torus(1, 0.25, 2), 7.07, 5e-3},    {torus(1, 0.25, 3), 7.65, 5e-3},     {torus(1, 0.25, 4), 8.35, 5e-3},
      {torus(0.6, 0.35, 2), 3.56, 5e-3},  {torus(0.6, 0.35, 3), 3.74, 5e-3},   {torus(0.6, 0.35, 4), 4.01, 5e-3},
      {{.profile_power = 2}, 1.00, 5e-3}, {{.profile_power = 3}, 0.889, 5e-4}, {{.profile_power = 4}, 0.844, 5e-4},
      {drum(0.8, 2), 1.00, 5e-3},         {drum(0.8, 4), 0.844, 5e-4},         {drum(0.3, 4), 1.37, 5e-3}};
  for (const Row& row : rows) {
    const Vortex3d motion{row.shape, {}, {}};
    EXPECT_NEAR(2 * motion.largest_xi(), row.gamma, row.digits) << row.shape.profile_power;
  }
  // of the ball xi = m s^2 (1 - s^2)^(m - 1) on its equator, largest at s^2 = 1/m
  for (const int m : {2, 3, 4, 9}) {
    const Vortex3d motion{{.profile_power = m}, {}, {}};
    EXPECT_NEAR(motion.largest_xi(), std::pow(1 - 1.0 / m, m - 1), rounding) << m;
  }
}

/// Of a thin torus xi = R m s (1 - s^2)^(m - 1)/w is largest at s = 1/sqrt(2 m - 1), up to w/R0.
TEST(Vortex3d, TheLargestShearOfAThinTorusIsFound) {
  for (const double thin : {1e-2, 1e-4, 1e-6}) {
    for (const int m : {2, 4}) {
      const double s = 1 / std::sqrt(2 * m - 1.0), wanted = m * s * std::pow(1 - s * s, m - 1) / thin;
      EXPECT_NEAR(Vortex3d({torus(1, thin, m), {}, {}}).largest_xi(), wanted, 2 * thin * wanted) << thin;
    }
  }
}

TEST(Vortex3d, NoPointHasALargerXiThanThePath) {
  std::mt19937 generator(2);
  std::uniform_real_distribution<double> share(-1, 1);
  for (const Revolution& shape : {torus(0.6, 0.35, 3), drum(0.3, 4), drum(1.4, 2), Revolution{}}) {
    const Vortex3d motion{shape, {}, {}};
    const Interval range = motion.baseline().parameter;
    EXPECT_EQ(range.lower, 0);
    double largest = 0;
    for (int k = 0; k < 20000; ++k) {
      const auto point = motion.place(Vector3(share(generator), share(generator), share(generator)));
      if (point) largest = std::max(largest, point->xi);
    }
    EXPECT_LE(largest, range.upper);
    EXPECT_GT(largest, 0.98 * range.upper);
  }
}

TEST(Vortex3d, PointsOnItsSurfaceAndOutsideAreAtRest) {
  Vortex3d motion{torus(1, 0.25, 2), {}, {Amplitude::Type::sine, 0.85, 1}};
  motion.one.axis = {1, 2, 3}, motion.one.center = {0.3, -0.2, 0.7};
  const Vector3 n = Vector3(1, 2, 3).normalized(), e = n.unitOrthogonal();
  for (const double angle : {0.0, 1.0, 2.5, 4.0}) {
    const Vector3 edge = motion.one.center + (1 + 0.25 * std::cos(angle)) * e + 0.25 * std::sin(angle) * n;
    for (const Vector3& X : {edge, Vector3(motion.one.center), Vector3(5, 5, 5)}) {
      const ExactState now = motion.at(X, 0.4);
      EXPECT_LT((now.x - X).norm(), rounding);
      EXPECT_LT(now.v.norm(), rounding);
      EXPECT_LT((now.F - Tensor::Identity()).norm(), rounding);
    }
  }
}

/// A disc through the middle of a torus is the plane vortex between R0 - w and R0 + w.
TEST(Vortex3d, OnItsEquatorATorusMovesAsThePlaneVortex) {
  const Vortex3d motion{torus(1, 0.25, 2), {}, {Amplitude::Type::sine, 0.85, 1}};
  const Motion plane;  // of the paper: inner .75, outer 1.25, m = 2
  for (const Vector3& X : {Vector3(0.9, 0.1, 0), Vector3(-0.5, 0.9, 0), Vector3(0.2, -1.2, 0)}) {
    Motion vortex = plane;
    const double ratio = 0.85 / vortex->amplitude()->peak;
    const auto p = motion.place(X);
    ASSERT_TRUE(p);
    EXPECT_NEAR(p->profile.h * 0.85, ratio * vortex->polar()->profile(X.norm()).h * vortex->amplitude()->peak,
                rounding);
    EXPECT_NEAR(p->xi, std::abs(vortex->polar()->profile(X.norm()).xi), rounding);
  }
}

TEST(Vortex3d, SeveralVorticesTurnEachAboutItsOwnAxis) {
  Vortex3d motion;
  motion.vortices = {Revolution{.radius = 0.4, .axis = {1, 2, 3}, .center = {0.5, 0, 0}},
                     Revolution{.radius = 0.3, .axis = {1, 0, 0}, .center = {-0.3, 0.1, 0}, .strength = -0.5}};
  motion.amplitude = {Amplitude::Type::sine, 1, 1};
  EXPECT_FALSE(motion.overlap());
  for (const Revolution& each : motion.vortices) {
    const Vortex3d alone{each, {}, motion.amplitude};
    const Vector3 X = each.center + each.radius * Vector3(0.2, 0.4, -0.1);
    EXPECT_EQ(motion.at(X, 0.4).x, alone.at(X, 0.4).x);
    EXPECT_EQ(motion.at(X, 0.4).F, alone.at(X, 0.4).F);
    EXPECT_GT((motion.at(X, 0.4).x - X).norm(), 0.01);
  }
  const double of_first = Vortex3d{motion.vortices[0], {}, {}}.largest_xi();
  EXPECT_EQ(motion.largest_xi(), of_first);
}

TEST(Vortex3d, AFinderPlacesPointsAsTheMotionDoes) {
  Vortex3d motion;
  for (int k = 0; k < 60; ++k) {
    const Vector3 center(k % 4, k / 4 % 4, k / 16);
    motion.vortices.push_back({.radius = 0.5, .axis = {1, 2, 3.0 + k}, .center = center});
    if (k % 3 == 1) motion.vortices.back() = torus(0.35, 0.15, 3), motion.vortices.back().center = center;
    if (k % 3 == 2) motion.vortices.back() = drum(0.4, 2), motion.vortices.back().center = center;
  }
  const VortexFinder finder(motion);
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> share(-1, 4);
  std::size_t inside = 0;
  for (int k = 0; k < 5000; ++k) {
    Vector3 X(share(generator), share(generator), share(generator));
    if (k % 3 == 0)
      X = motion.vortices[static_cast<std::size_t>(k) % 60].center + Vector3(0.5, 0, 0);  // where two touch
    const auto wanted = motion.place(X), found = finder.place(X);
    ASSERT_EQ(found.has_value(), wanted.has_value()) << X.transpose();
    if (!wanted) continue;
    ++inside;
    EXPECT_EQ(found->vortex, wanted->vortex);
    EXPECT_EQ(found->xi, wanted->xi);
  }
  EXPECT_GT(inside, 1000U);
}

TEST(Vortex3d, OverlapsAreFound) {
  const auto overlap = [](const Revolution& a, const Revolution& b) {
    Vortex3d motion;
    motion.vortices = {a, b};
    return motion.overlap();
  };
  const Revolution ball{.radius = 0.4};
  Revolution other{.radius = 0.3, .center = {0.7, 0, 0}};
  EXPECT_FALSE(overlap(ball, other));  // they touch
  other.center = {0.69, 0, 0};
  ASSERT_TRUE(overlap(ball, other));
  const Vector3 X = overlap(ball, other)->X;
  EXPECT_GT(ball.depth(X), 0);
  EXPECT_GT(other.depth(X), 0);
  Revolution small{.radius = 0.2};
  EXPECT_FALSE(overlap(torus(0.6, 0.35, 4), small));  // in the hole of the torus
  small.radius = 0.26;
  EXPECT_TRUE(overlap(torus(0.6, 0.35, 4), small));
  Revolution linked = torus(0.6, 0.2, 4);  // as links of a chain
  linked.axis = {1, 0, 0}, linked.center = {0, 0.6, 0};
  EXPECT_FALSE(overlap(torus(0.6, 0.2, 4), linked));
  linked.center = {0, 0.3, 0};
  EXPECT_TRUE(overlap(torus(0.6, 0.2, 4), linked));
  EXPECT_TRUE(overlap(ball, ball));
}

TEST(Vortex3d, ItsPathIsMadeAgainFromItsRecipe) {
  Vortex3d motion{torus(0.6, 0.35, 3), {}, {Amplitude::Type::one_minus_cosine, 0.4, 1.3}};
  motion.vortices = {Revolution{.radius = 0.3}, drum(0.2, 3)};
  const Path path = motion.baseline(), again = path_of_recipe(path.recipe);
  for (const double t : {0.2, 0.9}) {
    EXPECT_EQ(path.deformation_gradient(0.3, t), again.deformation_gradient(0.3, t));
  }
  EXPECT_EQ(path.parameter.upper, again.parameter.upper);
}

}  // namespace
}  // namespace assay::test_vortex3d
