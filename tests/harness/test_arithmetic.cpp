// SPDX-License-Identifier: BSD-3-Clause
#include "harness/arithmetic.hpp"

#include <gtest/gtest.h>

#include <cfenv>

#include "harness/material.hpp"
#include "tests/harness/elastic_material.hpp"

namespace assay::test_arithmetic {
namespace {

TEST(Arithmetic, TellsAndUndoesChanges) {
  EXPECT_EQ(changes_of_arithmetic(), arithmetic_kept);
  std::fesetround(FE_UPWARD);
  EXPECT_EQ(changes_of_arithmetic(), rounding_changed);
  ::feenableexcept(FE_INVALID);
  const std::uint32_t both = changes_of_arithmetic();
  reset_arithmetic();
  EXPECT_EQ(both, rounding_changed | traps_enabled);
  EXPECT_EQ(changes_of_arithmetic(), arithmetic_kept);
}

/// Neo-Hookean elasticity that leaves the processor rounding upward.
const assay_material* upward_table() {
  static const assay_material table = [] {
    assay_material t = elastic_material()->table();
    t.update = [](void* self, const assay_step* step, std::size_t n, const double* state0, double* state1,
                  double* cauchy, std::int32_t* status, double* dt_factor, char* message) {
      elastic_material()->table().update(self, step, n, state0, state1, cauchy, status, dt_factor, message);
      std::fesetround(FE_UPWARD);
    };
    return t;
  }();
  return &table;
}

TEST(Arithmetic, ChangedByAModelIsAFailureAndPutRight) {
  const Material material(upward_table(), {{"E", 1e3}, {"nu", 0.3}});
  const double F[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  double cauchy[9];
  const UpdateReport report = material.update(0, 1, 1, F, F, nullptr, nullptr, cauchy);
  EXPECT_EQ(report.worst, ASSAY_FAILED);
  EXPECT_EQ(report.message, "arithmetic: the material changes the rounding mode of the process");
  EXPECT_EQ(changes_of_arithmetic(), arithmetic_kept);
}

}  // namespace
}  // namespace assay::test_arithmetic
