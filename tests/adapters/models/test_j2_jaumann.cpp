// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/adapters/models/references/j2_jaumann.hpp"

namespace assay::model_tests {
namespace {

using j2_jaumann::integrated, j2_jaumann::Result;

const Hardening hardenings[] = {{}, {20, 60, 0, 0, 0}, {20, 30, 15, 12, 0}, {20, 30, 15, 12, 80}};
const History histories[] = {cyclic_shear(0.5), stretch_and_rotation(0.1)};

/// Yield points and reversals fall inside steps, at another place in each level: the mean order over five halvings.
TEST(J2Jaumann, IncrementsConvergeToTheRateEquationsAtSecondOrder) {
  for (const Hardening& h : hardenings) {
    const Material material = material_of("j2_jaumann", h.parameters());
    for (const History& history : histories) {
      const Result exact = integrated(h, history);
      ASSERT_GT(exact.p, 0.1);
      const auto errors = errors_under_refinement(material, history, exact.stress, 100, 6);
      EXPECT_GT(order_of(errors), 1.8);
      EXPECT_LT(errors.back(), 1e-6);
      EXPECT_NEAR(marched(material, history.F, history.end, 3200).state[0], exact.p, 1e-6);
    }
  }
}

TEST(J2Jaumann, OtherHardeningIsCaught) {
  const History history = cyclic_shear(0.5);
  const Hardening sound{20, 30, 15, 12, 80};
  const Material material = material_of("j2_jaumann", sound.parameters());
  for (const Hardening& other :
       {Hardening{20.1, 30, 15, 12, 80}, Hardening{20, 30.3, 15, 12, 80}, Hardening{20, 30, 15.2, 12, 80},
        Hardening{20, 30, 15, 6, 80}, Hardening{20, 30, 15, 12, 81}}) {
    const auto errors = errors_under_refinement(material, history, integrated(other, history).stress, 400, 3);
    EXPECT_GT(errors.back(), 2e-4);
    EXPECT_LT(order_of(errors), 0.5);
  }
}

TEST(J2Jaumann, LongStepsStayNearTheYieldSurface) { expect_long_steps("j2_jaumann"); }

TEST(J2Jaumann, CarriesAnInitialStressUpToYield) { expect_initial_stress("j2_jaumann"); }

}  // namespace
}  // namespace assay::model_tests
