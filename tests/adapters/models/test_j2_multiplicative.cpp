// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/adapters/models/references/j2_multiplicative.hpp"

namespace assay::model_tests::test_j2_multiplicative {
namespace {

const auto exact = [](const Hardening& h, const History& history) { return j2_multiplicative::integrated(h, history); };

const Hardening hardenings[] = {
    {}, {20, 60, 0, 0, 0}, {20, 30, 15, 12, 0}, {20, 30, 15, 12, 80}, {60, 30, 15, 12, 300}};
const History histories[] = {cyclic_shear(0.8), stretch_and_rotation(0.2)};

TEST(J2Multiplicative, IncrementsConvergeToTheRateEquationsAtSecondOrder) {
  for (const Hardening& h : hardenings) {
    for (const History& history : histories) expect_second_order("j2_multiplicative", h, history, exact, 1e-5);
  }
}

TEST(J2Multiplicative, OtherHardeningIsCaught) {
  expect_other_hardening_caught("j2_multiplicative", stretch_and_rotation(0.2), exact, 1e-4);
}

TEST(J2Multiplicative, PlasticFlowKeepsTheVolume) {
  const Material material = material_of("j2_multiplicative", hardenings[3].parameters());
  const Point end = marched(material, histories[1].F, histories[1].end, 200);
  const double* c = &end.state[1];
  Tensor metric;
  metric << c[0], c[3], c[4], c[3], c[1], c[5], c[4], c[5], c[2];
  EXPECT_GT(difference(metric, Tensor::Identity()), 0.1);
  EXPECT_NEAR(metric.determinant(), 1, 1e-12);
}

/// An elastic step of half a turn and a large change of volume: the state stays, bit for bit.
TEST(J2Multiplicative, ElasticStepsLeaveTheStateAlone) {
  const Material material = material_of("j2_multiplicative", hardenings[1].parameters());
  const Tensor F0 = histories[1].F(0.5);
  const Point loaded = marched(material, histories[1].F, 0.5, 50);
  const Point turned = point_after(material, 0.5, 0.1, F0, turn(3.1) * F0, loaded.state);
  EXPECT_EQ(turned.state, loaded.state);
  const Point swollen = point_after(material, 0.5, 0.1, F0, turn(3.1) * F0 * 1.2, loaded.state);
  EXPECT_EQ(swollen.state, loaded.state);
}

TEST(J2Multiplicative, LongStepsStayNearTheYieldSurface) { expect_long_steps("j2_multiplicative"); }

TEST(J2Multiplicative, CarriesAnInitialStressUpToYield) { expect_initial_stress("j2_multiplicative"); }

}  // namespace
}  // namespace assay::model_tests::test_j2_multiplicative
