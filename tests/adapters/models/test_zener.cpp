// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/adapters/models/references/zener.hpp"

namespace assay::model_tests::test_zener {
namespace {

const Lame elastic(1000, 0.3);

Parameters with(double ratio, double time) {
  return {{"E", 1000}, {"nu", 0.3}, {"viscous_ratio", ratio}, {"relaxation_time", time}};
}

Tensor integrated(const History& history, double ratio, double time) {
  return zener_stress(history, elastic, ratio, time);
}

TEST(Zener, IncrementsConvergeToTheRateEquationAtSecondOrder) {
  for (const History& history : {cyclic_shear(1.6), stretch_and_rotation(0.25)}) {
    for (const double time : {0.02, 0.3, 5.0}) {
      const Material material = material_of("zener", with(1.7, time));
      const auto errors = errors_under_refinement(material, history, integrated(history, 1.7, time), 64, 4);
      EXPECT_GT(order_of(errors), 1.9) << time;
      EXPECT_LT(order_of(errors), 2.2) << time;
      EXPECT_LT(errors.back(), 1e-4) << time;
      const auto wrong = errors_under_refinement(material, history, integrated(history, 1.7, 1.05 * time), 64, 4);
      EXPECT_GT(wrong.back(), 2e-4) << time;
      EXPECT_LT(order_of(wrong), 1.5) << time;
    }
  }
}

TEST(Zener, WithoutViscosityIsNeoHookean) {
  const Material zener = material_of("zener", with(0, 1)),
                 neo_hookean = material_of("neo_hookean", {{"E", 1000}, {"nu", 0.3}});
  const History history = stretch_and_rotation(0.25);
  const Tensor expected = marched(neo_hookean, history.F, history.end, 3).cauchy;
  EXPECT_LT(difference(marched(zener, history.F, history.end, 3).cauchy, expected), 1e-12 * expected.norm());
}

/// A step from rest of D = dt/time: S_v = ratio mu (I - C^-1) (1 - exp(-D))/D; held for T after it: falls by
/// exp(-T/time).
TEST(Zener, RelaxesExactlyAndKeepsItsDigitsAtSmallSteps) {
  Tensor F = Tensor::Identity();
  F(1, 0) = 0.7;
  const Tensor change = Tensor::Identity() - (F.transpose() * F).inverse();
  for (const double D : {1e-12, 1e-6, 1e-2, 3.0, 800.0}) {
    const Material material = material_of("zener", with(2, 1));
    const Point loaded = point_after(material, 0, D, Tensor::Identity(), F, material.initial_state(1));
    const double expected = 2 * elastic.mu * change(0, 1) * -std::expm1(-D) / D;
    EXPECT_NEAR(loaded.state[3], expected, 1e-14 * std::abs(expected)) << D;
    const Point held = point_after(material, D, 0.5, F, F, loaded.state);
    EXPECT_NEAR(held.state[3], expected * std::exp(-0.5), 1e-14 * std::abs(expected)) << D;
  }
}

}  // namespace
}  // namespace assay::model_tests::test_zener
