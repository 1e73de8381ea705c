// SPDX-License-Identifier: BSD-3-Clause
// Every motion is undone by its inverse, whatever its formula.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "harness/motion/frame.hpp"
#include "harness/motion/kinds/axis_aligned.hpp"
#include "harness/motion/kinds/twisting_ring.hpp"
#include "harness/motion/kinds/vortex3d.hpp"
#include "tests/harness/motion/all_motions.hpp"

namespace assay::test_reference_of {
namespace {

constexpr double size = 1.5;           ///< of the bodies [m]
constexpr double of_rounding = 1e-12;  ///< of the size
constexpr double of_newton = 1e-9;     ///< of the size: the profile of a vortex has a kink in its third derivative

/// Where radii change there is no point but in the ring.
bool is_open(const Motion& motion) { return motion->polar() && motion->polar()->widens(); }

/// Random places, and those where formulas change: axes, edges, planes of symmetry.
std::vector<Vector3> places(const Motion& motion, int count) {
  std::vector<Vector3> all;
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> share(-1, 1);
  for (int k = 0; k < count; ++k)
    all.emplace_back(size * Vector3(share(generator), share(generator), share(generator)));
  for (const double a : {0.0, 0.5, 1.0, -1.0}) {
    for (const double b : {0.0, 0.3}) all.insert(all.end(), {Vector3(a, b, 0), Vector3(b, a, 0), Vector3(0, b, a)});
  }
  if (const auto ring = ring_of(motion)) {
    for (const double R : {ring->inner, ring->outer, 0.5 * (ring->inner + ring->outer)}) {
      for (const double angle : {0.0, 0.7, 2.9}) all.emplace_back(R * std::cos(angle), R * std::sin(angle), 0.2);
    }
    std::erase_if(all, [&](const Vector3& X) {
      const double R = std::hypot(X.x(), X.y()), slack = 1e-15;
      return is_open(motion) && (R < ring->inner * (1 - slack) || R > ring->outer * (1 + slack));
    });
  }
  if (const auto* vortex = motion.as<Vortex3d>()) {
    for (const Revolution& r : vortex->all()) {
      const Vector3 n = r.axis.normalized(), radial = n.unitOrthogonal();
      all.insert(all.end(), {r.center, r.center + 0.4 * r.radius * n, r.center + r.radius * n,
                             r.center + r.radius * radial, r.center + 0.3 * r.radius * radial});
    }
  }
  return all;
}

const std::vector<double> times{0, 0.17, 0.5, 0.93, 1.61};

TEST(ReferenceOf, UndoesEveryMotion) {
  for (const auto& [name, motion] : all_motions()) {
    for (const Vector3& X : places(motion, 200)) {
      for (const double t : times) {
        const auto found = motion->reference_of(motion->at(X, t).x, t);
        ASSERT_TRUE(found) << name << " " << X.transpose() << " at " << t;
        EXPECT_LT((*found - X).norm(), of_rounding * size) << name << " " << X.transpose() << " at " << t;
      }
    }
  }
}

/// The other way: where a point is found, the motion takes it there.
TEST(ReferenceOf, IsUndoneByEveryMotion) {
  for (const auto& [name, motion] : all_motions()) {
    int there = 0;
    for (const Vector3& x : places(motion, 100)) {
      for (const double t : times) {
        const auto found = motion->reference_of(x, t);
        ASSERT_TRUE(found || is_open(motion)) << name;
        if (!found) continue;
        ++there;
        EXPECT_LT((motion->at(*found, t).x - x).norm(), of_rounding * size) << name << " " << x.transpose();
      }
    }
    EXPECT_GT(there, 40) << name;
  }
}

TEST(ReferenceOf, IsTheSamePointSeenFromAnyFrame) {
  const Frame plane{0.7, 1.3, {0.4, -0.2, 0}}, tilted{0.7, -2.3, {0.4, -0.2, 0.5}, {2, -1, 3}};
  for (const auto& [name, motion] : all_motions()) {
    for (const Frame& frame : {plane, tilted}) {
      for (const Vector3& own : places(motion, 40)) {
        for (const double t : times) {
          const Vector3 X = frame.rotation(0) * own, x = frame.seen(motion->at(frame.body_point(X), t), t).x;
          const auto found = motion->reference_of(frame.body_position(x, t), t);
          // of a point on an edge the turn may make one outside
          ASSERT_TRUE(found) << name << " " << own.transpose();
          EXPECT_LT((frame.rotation(0) * *found - X).norm(), of_rounding * size) << name << " " << own.transpose();
        }
      }
    }
  }
}

/// Formulas against the method of those motions that have none. Beyond its faces the formula of a ring that widens
/// comes to the same places again.
TEST(ReferenceOf, FormulasFindWhatNewtonsMethodFinds) {
  for (const auto& [name, motion] : all_motions()) {
    if (is_open(motion)) continue;
    for (const Vector3& X : places(motion, 60)) {
      for (const double t : times) {
        const Vector3 x = motion->at(X, t).x;
        const auto newton = motion->MotionKind::reference_of(x, t), formula = motion->reference_of(x, t);
        ASSERT_TRUE(newton && formula) << name << " " << X.transpose() << " at " << t;
        EXPECT_LT((*newton - *formula).norm(), of_newton * size) << name << " " << X.transpose() << " at " << t;
      }
    }
  }
}

/// Close to det F = 0: the root is where a slope is almost none.
TEST(ReferenceOf, OfABoxThatIsAlmostFolded) {
  constexpr double almost = 0.3183;  // of 1/pi = 0.31831
  const Motion box = AxisAligned{{Amplitude::Type::sine, almost, 1}, false, true};
  for (int k = 0; k <= 400; ++k) {
    const Vector3 X(k / 400.0, 1 - k / 400.0, 0);
    const ExactState now = box->at(X, 0.5);
    const double smallest = now.F.diagonal().minCoeff();
    const auto found = box->reference_of(now.x, 0.5);
    // what rounding of x is worth, or where the slope itself is none, its square root
    EXPECT_LT((*found - X).norm(), 1e-15 / smallest + 1e-13) << k;
    EXPECT_LT((box->at(*found, 0.5).x - now.x).norm(), 1e-15) << k;
  }
}

TEST(ReferenceOf, IsNoneWhereNoPointOfAWideningRingIs) {
  TwistingRing twisting;
  twisting.expansion = 0.1;
  const Motion ring = twisting;
  const double t = 0.5, inner = twisting.ring(twisting.inner(), t).rho, outer = twisting.ring(twisting.outer(), t).rho;
  for (const double rho : {0.0, 0.5 * inner, inner - 1e-6, outer + 1e-6, 10.0, HUGE_VAL, std::nan("")}) {
    EXPECT_FALSE(ring->reference_of({rho, 0, 0}, t)) << rho;
  }
  EXPECT_TRUE(ring->reference_of({inner + 1e-6, 0, 0}, t));
  EXPECT_TRUE(ring->reference_of({0, outer - 1e-6, 0}, t));
}

TEST(ReferenceOf, OfAPointAtRestIsThePoint) {
  for (const auto& [name, motion] : all_motions()) {
    for (const Vector3& x : places(motion, 10)) EXPECT_LT((*motion->reference_of(x, 0) - x).norm(), 1e-15) << name;
  }
  const Vector3 outside(1.4, 0.2, 0.1), axis(0, 0, 0.4);
  for (const Vector3& x : {outside, axis}) EXPECT_EQ(*Motion(Vortex{})->reference_of(x, 0.5), x);
}

}  // namespace
}  // namespace assay::test_reference_of
