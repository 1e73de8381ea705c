// SPDX-License-Identifier: BSD-3-Clause
#include "harness/regime.hpp"

#include <gtest/gtest.h>

namespace assay::test_regime {
namespace {

assay_material table_with(const assay_state_variable* state, std::uint32_t count) {
  assay_material table{};
  table.state = state;
  table.state_count = count;
  return table;
}

TEST(Regime, IsTheSetOfScalarsThatAStepHasChanged) {
  const assay_state_variable state[] = {{"stress", "Pa", ASSAY_SYMMETRIC_TENSOR, 0, ""},
                                        {"plastic_strain", "1", ASSAY_SCALAR, 0, ""},
                                        {"damage", "1", ASSAY_SCALAR, 0, ""}};
  const RegimeReader reader(table_with(state, 3));
  ASSERT_TRUE(reader.tells());
  const double before[8] = {1, 2, 3, 4, 5, 6, 0.1, 0.2};
  double elastic[8] = {9, 9, 9, 9, 9, 9, 0.1, 0.2}, plastic[8] = {9, 9, 9, 9, 9, 9, 0.1 + 1e-16, 0.2},
         both[8] = {9, 9, 9, 9, 9, 9, 0.3, 0.4}, healed[8] = {9, 9, 9, 9, 9, 9, 0.1, 0};
  EXPECT_EQ(reader.of(before, elastic), 0u);
  EXPECT_NE(reader.of(before, plastic), 0u);
  EXPECT_NE(reader.of(before, both), reader.of(before, plastic));
  EXPECT_EQ(reader.of(before, healed), 0u) << "back at zero is at rest";
}

TEST(Regime, IsNamedWhereTheMaterialNamesIt) {
  const assay_state_variable state[] = {{"plastic_strain", "1", ASSAY_SCALAR, 0, ""},
                                        {"active", "regime", ASSAY_SCALAR, 0, ""}};
  const RegimeReader reader(table_with(state, 2));
  const double before[2] = {0.1, 0}, flows[2] = {0.1, 1}, rests[2] = {0.2, 0};
  EXPECT_NE(reader.of(before, flows), reader.of(before, rests));
  EXPECT_EQ(reader.of(flows, rests), reader.of(before, rests));
}

TEST(Regime, IsUnknownWithoutScalars) {
  const assay_state_variable state[] = {{"stress", "Pa", ASSAY_SYMMETRIC_TENSOR, 0, ""}};
  EXPECT_FALSE(RegimeReader(table_with(state, 1)).tells());
  EXPECT_FALSE(RegimeReader(table_with(nullptr, 0)).tells());
}

}  // namespace
}  // namespace assay::test_regime
