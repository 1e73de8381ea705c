// SPDX-License-Identifier: BSD-3-Clause
#include "harness/history/history.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

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

const assay_state_variable of_a_umat[] = {{"back_stress", "Pa", ASSAY_SYMMETRIC_TENSOR, 0, ""},
                                          {"TIME", "s", ASSAY_SCALAR, 0, ""},
                                          {"SPD", "J/m^3", ASSAY_SCALAR, 0, ""},
                                          {"plastic", "1", ASSAY_TENSOR, 0, ""}};
constexpr std::size_t umat_size = 6 + 1 + 1 + 9;

/// 1: so the variable does.
StateSigns signs_of(const std::array<char, 4>& changes, const std::array<char, 4>& always) {
  StateSigns signs;
  signs.changes.assign(changes.begin(), changes.end());
  signs.always.assign(always.begin(), always.end());
  signs.ever = signs.always;
  signs.any_start = true;
  return signs;
}

TEST(Regime, IsNotToldByAClock) {
  const assay_material table = table_with(of_a_umat, 4);
  RegimeReader reader(table);
  const double before[umat_size] = {1, 2, 3, 4, 5, 6, 0.1, 7};
  double later[umat_size] = {1, 2, 3, 4, 5, 6, 0.2, 7}, flowed[umat_size] = {1, 2, 3, 4, 5, 6, 0.2, 7.1};
  EXPECT_NE(reader.of(before, later), 0u);
  reader.settle(table, signs_of({1, 1, 1, 1}, {0, 1, 0, 0}));
  EXPECT_EQ(reader.of(before, later), 0u);
  EXPECT_NE(reader.of(before, flowed), 0u);
  later[0] = 9;
  EXPECT_EQ(reader.of(before, later), 0u) << "a scalar tells: a tensor is not asked";
}

TEST(Regime, IsToldByTheInvariantsOfATensorWhereNoScalarChanges) {
  const assay_material table = table_with(of_a_umat, 4);
  RegimeReader reader(table);
  reader.settle(table, signs_of({1, 1, 0, 0}, {0, 1, 0, 0}));
  ASSERT_TRUE(reader.tells());
  const double c = std::cos(0.3), s = std::sin(0.3), a = 3, b = -1;  // diag(a, b, 2) turned about 3
  const double before[umat_size] = {a, b, 2, 0, 0, 0, 0.1};
  const double turned[umat_size] = {a * c * c + b * s * s, a * s * s + b * c * c, 2, (a - b) * s * c, 0, 0, 0.2},
               grown[umat_size] = {a + 1e-11, b, 2, 0, 0, 0, 0.2}, other[umat_size] = {a, b, 2, 0, 0, 0, 0.2, 0, 1};
  EXPECT_EQ(reader.of(before, turned), 0u);
  EXPECT_NE(reader.of(before, grown), 0u);
  EXPECT_EQ(reader.of(before, other), 0u) << "the other tensor has never changed";
}

/// A back stress whose components are declared as scalars, turned by the model in elastic steps.
TEST(Regime, IsNotToldByWhatTurnsBesideWhatDoesNot) {
  const assay_state_variable state[] = {
      {"s1", "1", ASSAY_SCALAR, 0, ""}, {"s2", "1", ASSAY_SCALAR, 0, ""}, {"s3", "1", ASSAY_SCALAR, 0, ""}};
  const assay_material table = table_with(state, 3);
  StateSigns signs;
  signs.changes = {1, 1, 1}, signs.always = {0, 0, 0}, signs.ever = {1, 1, 0}, signs.any_start = true;
  RegimeReader reader(table);
  reader.settle(table, signs);
  const double before[] = {1, 2, 0.1}, turned[] = {1.1, 1.9, 0.1}, flowed[] = {1, 2, 0.2};
  EXPECT_EQ(reader.of(before, turned), 0u);
  EXPECT_NE(reader.of(before, flowed), 0u);
  signs.ever = {1, 1, 1};
  RegimeReader unsettled(table);
  unsettled.settle(table, signs);
  EXPECT_NE(unsettled.of(before, turned), 0u) << "nothing tells better";
}

TEST(Regime, StaysAsDeclaredWhereNoStepWasTaken) {
  const assay_material table = table_with(of_a_umat, 4);
  RegimeReader reader(table);
  StateSigns signs = signs_of({0, 0, 0, 0}, {1, 1, 1, 1});
  signs.any_start = false;
  reader.settle(table, signs);
  EXPECT_TRUE(reader.tells());
}

TEST(Regime, IsUnknownWithoutScalars) {
  const assay_state_variable state[] = {{"stress", "Pa", ASSAY_SYMMETRIC_TENSOR, 0, ""}};
  EXPECT_FALSE(RegimeReader(table_with(state, 1)).tells());
  EXPECT_FALSE(RegimeReader(table_with(nullptr, 0)).tells());
}

TEST(Regime, OfATensorIsToldInAnyUnit) {
  for (const double unit : {1e-300, 1e-160, 1.0, 1e160, 1e300}) {
    const double before[6] = {unit, 2 * unit, -unit, 0.5 * unit, 0, 0};
    const double turned[6] = {2 * unit, unit, -unit, -0.5 * unit, 0, 0};  // by a right angle about the third axis
    const double grown[6] = {1.1 * unit, 2 * unit, -unit, 0.5 * unit, 0, 0};
    EXPECT_FALSE(variable_changes(ASSAY_SYMMETRIC_TENSOR, before, turned)) << unit;
    EXPECT_TRUE(variable_changes(ASSAY_SYMMETRIC_TENSOR, before, grown)) << unit;
  }
  const double nothing[6] = {};
  EXPECT_FALSE(variable_changes(ASSAY_SYMMETRIC_TENSOR, nothing, nothing));
}

}  // namespace
}  // namespace assay::test_regime
