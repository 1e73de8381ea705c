// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/adapters/models/references/j2_jaumann.hpp"

namespace assay::model_tests::test_j2_jaumann {
namespace {

const auto exact = [](const Hardening& h, const History& history) { return j2_jaumann::integrated(h, history); };

const Hardening hardenings[] = {{}, {20, 60, 0, 0, 0}, {20, 30, 15, 12, 0}, {20, 30, 15, 12, 80}};
const History histories[] = {cyclic_shear(0.5), stretch_and_rotation(0.1)};

TEST(J2Jaumann, IncrementsConvergeToTheRateEquationsAtSecondOrder) {
  for (const Hardening& h : hardenings) {
    for (const History& history : histories) expect_second_order("j2_jaumann", h, history, exact, 1e-6);
  }
}

TEST(J2Jaumann, OtherHardeningIsCaught) { expect_other_hardening_caught("j2_jaumann", cyclic_shear(0.5), exact, 2e-4); }

TEST(J2Jaumann, LongStepsStayNearTheYieldSurface) { expect_long_steps("j2_jaumann"); }

TEST(J2Jaumann, CarriesAnInitialStressUpToYield) { expect_initial_stress("j2_jaumann"); }

}  // namespace
}  // namespace assay::model_tests::test_j2_jaumann
