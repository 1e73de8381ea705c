// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/check/check_foreign.hpp"

#include <gtest/gtest.h>

#include "tests/drivers/foreign_checks.hpp"

namespace assay::drivers::test_check_state_blocks {
namespace {

std::string kinematic(const std::string& words, const std::string& state, const std::string& yield = "10") {
  return "interface: umat\nflags: [non_smooth]\nproperties: {E: 1.0e3, nu: 0.3, yield: " + yield +
         ", C: 50}\nstate: " + state + "\nmaterial_name: " + words + "\n";
}

class StateBlocks : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_foreign("umat_kinematic")) GTEST_SKIP() << "no Fortran compiler";
  }
};
using LongStateBlocks = StateBlocks;

TEST_F(StateBlocks, AnUnturnedTensorThatNobodyHasDeclaredIsFound) {
  const ForeignCheck check("umat_kinematic", kinematic("UNTURNED", "7"));
  EXPECT_EQ(check.status, 1) << check.said;
  EXPECT_EQ(check.cause(), check::causes::state_not_rotated) << check.said;
  EXPECT_NE(check.sentence().find("'STATEV(1:6)' of the state does not rotate with the body, although the next step"),
            std::string::npos)
      << check.sentence();
  EXPECT_NE(check.sentence().find("`state: {t1: symmetric_tensor, s7: scalar}`"), std::string::npos)
      << check.sentence();
}

TEST_F(StateBlocks, WhereverItBegins) {
  const ForeignCheck check("umat_kinematic", kinematic("UNTURNED P_FIRST", "7"));
  EXPECT_EQ(check.cause(), check::causes::state_not_rotated) << check.said;
  EXPECT_NE(check.sentence().find("'STATEV(2:7)'"), std::string::npos) << check.sentence();
}

TEST_F(StateBlocks, TwoOfThemAreToldFromEachOther) {
  const ForeignCheck check("umat_kinematic", kinematic("UNTURNED TWO_TENSORS", "13"));
  EXPECT_EQ(check.cause(), check::causes::state_not_rotated) << check.said;
  EXPECT_NE(check.sentence().find("`state: {t1: symmetric_tensor, s7: scalar, t2: strain}`"), std::string::npos)
      << check.sentence();
}

TEST_F(LongStateBlocks, AVectorKeepsItsFirstValue) {
  const std::string known = "{b: symmetric_tensor, p: scalar, ", keys = "symmetry: anisotropic\n", elastic = "1.0e3";
  const std::string counted = known + "a1: {initial: 1}, a2: {initial: 0}, a3: {initial: 0}}";
  const ForeignCheck check("umat_kinematic", keys + kinematic("FIBRE UNTURNED", counted, elastic));
  EXPECT_EQ(check.cause(), check::causes::state_not_rotated) << check.said;
  EXPECT_NE(check.sentence().find("'STATEV(8:10)'"), std::string::npos) << check.sentence();
  EXPECT_NE(check.sentence().find("t1: {kind: vector, initial: [1, 0, 0]}"), std::string::npos) << check.sentence();
  const ForeignCheck right("umat_kinematic", keys + kinematic("FIBRE", counted, elastic));
  EXPECT_EQ(right.status, 0) << right.said;
}

TEST_F(LongStateBlocks, ThoseThatTurnAreNoDefectUndeclared) {
  for (const char* words : {"ASSAY", "P_FIRST"}) {
    const ForeignCheck check("umat_kinematic", kinematic(words, "7"));
    EXPECT_EQ(check.status, 0) << check.said;
  }
  const ForeignCheck two("umat_kinematic", kinematic("TWO_TENSORS", "13"));
  EXPECT_EQ(two.status, 0) << two.said;
}

/// The first component of the back stress is said to be a scalar.
TEST_F(StateBlocks, WhereNothingFitsItIsAskedFor) {
  const ForeignCheck check("umat_kinematic", kinematic("UNTURNED", "{x: scalar, y: {count: 6}}"));
  EXPECT_EQ(check.status, 1) << check.said;
  EXPECT_NE(check.sentence().find("one of the numbers of `state` belongs to a tensor"), std::string::npos)
      << check.said;
}

TEST_F(StateBlocks, DeclaredItKeepsItsName) {
  const ForeignCheck check("umat_kinematic", kinematic("UNTURNED", "{back_stress: symmetric_tensor, p: scalar}"));
  EXPECT_EQ(check.cause(), check::causes::state_not_rotated) << check.said;
  EXPECT_NE(check.sentence().find("'back_stress'"), std::string::npos) << check.sentence();
}

TEST(WithBlocks, TakesTheFirstValuesAlong) {
  adapters::ForeignModel model;
  for (int k = 1; k <= 8; ++k) {
    model.state.push_back({"s" + std::to_string(k)});
    model.state.back().kind_is_said = false;
    model.state.back().initial = {1.0 * k};
  }
  const adapters::ForeignModel other = with_blocks(model, {{1, adapters::ForeignVariable::Kind::strain}});
  ASSERT_EQ(other.state.size(), 3u);
  EXPECT_EQ(other.state[0].name, "s1");
  EXPECT_EQ(other.state[1].name, "STATEV(2:7)");
  EXPECT_EQ(other.state[1].initial, (std::vector<double>{2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(other.state[2].name, "s8");
}

}  // namespace
}  // namespace assay::drivers::test_check_state_blocks
