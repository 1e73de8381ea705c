// SPDX-License-Identifier: BSD-3-Clause
#include "harness/motion/frame.hpp"

#include <gtest/gtest.h>

#include "harness/motion/kinds/vortex.hpp"
#include "harness/numeric/central_difference.hpp"

namespace assay::test_frame {
namespace {

const Frame frame{0.7, 1.3, {0.4, -0.2, 0}};
const Frame tilted{0.7, 1.3, {0.4, -0.2, 0.5}, {2, -1, 3}};
const Vortex vortex{0.75, 1.25, 2, {Amplitude::Type::one_minus_cosine, 0.9, 1.1}};

ExactState seen_at(const Vector3& X, double t, const Frame& by = frame) {
  return by.seen(vortex.at(by.body_point(X), t), t);
}

void check_derivatives(const Frame& by) {
  constexpr double step = 1e-3;
  for (const auto& [X, Y] : {std::pair{0.9, 0.3}, std::pair{-0.7, 0.8}, std::pair{0.1, -1.1}}) {
    for (const double t : {0.2, 0.61, 1.4}) {
      const Vector3 at = by.rotation(0) * Vector3(X, Y, 0);
      const ExactState state = seen_at(at, t, by);
      const Vector3 v = central_difference([&](int k) { return seen_at(at, t + k * step, by).x; }, step);
      const Vector3 a = central_difference([&](int k) { return seen_at(at, t + k * step, by).v; }, step);
      const Tensor rate = central_difference([&](int k) { return seen_at(at, t + k * step, by).F; }, step);
      EXPECT_LT((v - state.v).norm(), 1e-9 * state.v.norm());
      EXPECT_LT((a - state.a).norm(), 1e-9 * state.a.norm());
      EXPECT_LT((rate - state.F_rate).norm(), 1e-9 * state.F_rate.norm());
      for (int j = 0; j < 3; ++j) {
        const Vector3 column =
            central_difference([&](int k) { return seen_at(at + k * step * Vector3::Unit(j), t, by).x; }, step);
        EXPECT_LT((column - state.F.col(j)).norm(), 1e-8);
      }
    }
  }
}

TEST(Frame, ItsVelocityAccelerationAndDeformationAreDerivativesOfItsPosition) { check_derivatives(frame); }

TEST(Frame, SoTheyAreAboutAnyAxis) { check_derivatives(tilted); }

TEST(Frame, AnAxisMayBeOfAnyLengthAndTurnsByTheRightHand) {
  const Frame along_z{0.7, 1.3, {0.4, -0.2, 0}, {0, 0, 5e-170}}, against{-0.7, -1.3, {0.4, -0.2, 0}, {0, 0, -3}};
  const ExactState right = seen_at({0.9, 0.3, 0.2}, 0.4);
  EXPECT_EQ(seen_at({0.9, 0.3, 0.2}, 0.4, along_z).a, right.a);
  EXPECT_LT((seen_at({0.9, 0.3, 0.2}, 0.4, against).a - right.a).norm(), 1e-13 * right.a.norm());
}

TEST(Frame, StartsAtTheReferencePosition) {
  const Vector3 X(0.9, 0.3, 0);
  EXPECT_LT((seen_at(X, 0).x - X).norm(), 1e-15);
  EXPECT_LT((seen_at(X, 0).F - Tensor::Identity()).norm(), 1e-15);
}

TEST(Frame, TheVortexIsTheSameTurnedByTheAngleAlone) {
  const Frame basis{0.7};
  const Vector3 X(-0.4, 0.9, 0);
  const ExactState turned = basis.seen(vortex.at(basis.body_point(X), 0.4), 0.4), own = vortex.at(X, 0.4);
  EXPECT_FALSE(basis.moves());
  EXPECT_LT((turned.x - own.x).norm() + (turned.v - own.v).norm() + (turned.a - own.a).norm(), 1e-13);
  EXPECT_LT((turned.F - own.F).norm(), 1e-13);
}

TEST(Frame, TurnsStressWithTheMotionAndKeepsItsBalance) {
  const ExactState state = vortex.at({0.9, 0.3, 0}, 0.4);
  ExactStress stress;
  stress.first_piola_kirchhoff << 3, 1, 0, -2, 5, 0, 0, 0, 4;
  stress.cauchy = cauchy_stress(stress.first_piola_kirchhoff, state.F);
  const ExactStress seen = frame.seen(stress, state, 0.4);
  const Tensor F = frame.seen(state, 0.4).F;
  EXPECT_LT((seen.cauchy - cauchy_stress(seen.first_piola_kirchhoff, F)).norm(), 1e-13);
  EXPECT_NEAR(seen.cauchy.trace(), stress.cauchy.trace(), 1e-13);
}

}  // namespace
}  // namespace assay::test_frame
