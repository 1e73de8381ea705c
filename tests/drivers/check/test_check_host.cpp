// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/check/check_foreign.hpp"

#include <gtest/gtest.h>

#include "tests/drivers/foreign_checks.hpp"

namespace assay::drivers::test_check_host {
namespace {

std::string kinematic(const std::string& words, const std::string& keys = "") {
  return "interface: umat\nflags: [non_smooth]\nproperties: {E: 1.0e3, nu: 0.3, yield: 10, C: 50}\n"
         "state: {back_stress: symmetric_tensor, p: scalar, note: scalar}\nmaterial_name: " +
         words + "\n" + keys;
}

std::string vumat(const std::string& words) {
  return "interface: vumat\nflags: [non_smooth]\nproperties: {E: 1.0e3, nu: 0.3, yield: 10, H: 20}\nstate: 1\n"
         "material_name: " +
         words + "\n";
}

class Host : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_foreign("umat_kinematic")) GTEST_SKIP() << "no Fortran compiler";
  }
};
using LongHost = Host;

TEST_F(LongHost, ACounterIsNothingToDependOn) {
  const std::pair<const char*, const char*> all[] = {
      {"BY_KINC", "KINC"}, {"BY_KSTEP", "KSTEP"}, {"BY_NPT", "NPT"}, {"BY_LAYER", "LAYER"}};
  for (const auto& [words, name] : all) {
    const ForeignCheck check("umat_kinematic", kinematic(words));
    EXPECT_EQ(check.status, 1) << check.said;
    EXPECT_EQ(check.cause(), check::causes::host_counters) << check.said;
    EXPECT_NE(check.sentence().find(std::string("depends on ") + name + ": "), std::string::npos) << check.sentence();
    EXPECT_EQ(check.found["diagnosis"].size(), 1u) << check.said;
  }
}

TEST_F(LongHost, WhatMayBeMeantStandsOnTheVerdictLine) {
  const std::pair<const char*, const char*> all[] = {
      {"COORDS", "COORDS"}, {"BY_TEMP", "TEMP"}, {"BY_LENGTH", "CELENT"}, {"BY_FIELD", "PREDEF(1)"}};
  for (const auto& [words, name] : all) {
    const ForeignCheck check("umat_kinematic", kinematic(words));
    EXPECT_EQ(check.status, 0) << check.said;
    EXPECT_NE(check.dependence_on(name), "") << check.said;
    EXPECT_EQ(check.found["depends_on"].size(), 1u) << check.said;
    EXPECT_TRUE(check.says(std::string("; depends on ") + name + " (")) << check.said;
    EXPECT_NE(check.junit.find(std::string("depends on ") + name), std::string::npos);
  }
}

/// What a path may change is varied by the check as the rest is.
TEST_F(LongHost, FieldsThatMayVaryAreInputsAsOthers) {
  const std::string swelling = "fields: {swelling: 0}\nvarying: [swelling]\n", temperature = "varying: [temperature]\n";
  EXPECT_NE(ForeignCheck("umat_kinematic", kinematic("BY_FIELD", swelling)).dependence_on("PREDEF(1)"), "");
  EXPECT_NE(ForeignCheck("umat_kinematic", kinematic("BY_TEMP", swelling)).dependence_on("TEMP"), "");
  EXPECT_NE(ForeignCheck("umat_kinematic", kinematic("BY_TEMP", temperature)).dependence_on("TEMP"), "");
  EXPECT_NE(ForeignCheck("umat_kinematic", kinematic("BY_FIELD", temperature)).dependence_on("PREDEF(1)"), "");
}

/// The shear modulus, by 0.002 for each degree: 2 %, and less of the whole stress.
TEST_F(Host, TheSizeIsThatOfTheStress) {
  const ForeignCheck check("umat_kinematic", kinematic("BY_TEMP"));
  const std::string how = check.dependence_on("TEMP");
  EXPECT_TRUE(how.ends_with(" % for +10")) << how;
  const double share = std::stod(how);
  EXPECT_GT(share, 0.2) << how;
  EXPECT_LT(share, 2.1) << how;
}

TEST_F(Host, SetUpCodeMayAskForTheFirstIncrement) {
  const ForeignCheck check("umat_kinematic", kinematic("STARTS"));
  EXPECT_EQ(check.status, 0) << check.said;
  EXPECT_EQ(check.verdict_of(host_test), "pass");
  EXPECT_FALSE(check.found.contains("depends_on")) << check.said;
}

/// KINC is 1 again where another step of the analysis begins.
TEST_F(Host, SetUpCodeThatAsksForTheIncrementAloneIsFound) {
  const ForeignCheck check("umat_kinematic", kinematic("SETS_UP_AGAIN"));
  EXPECT_EQ(check.status, 1) << check.said;
  EXPECT_EQ(check.cause(), check::causes::host_counters) << check.said;
  EXPECT_NE(check.sentence().find("where a second step begins (KSTEP 2, KINC 1)"), std::string::npos) << check.said;
}

/// TIME(1) is 0 again there, and TIME(2) goes on.
TEST_F(Host, SetUpCodeThatAsksForTheStepTimeIsFound) {
  for (const char* words : {"NEW_AT_ZERO_TIME", "NEW_IN_SHORT_TIME", "NEW_BY_BOTH"}) {
    const ForeignCheck check("umat_kinematic", kinematic(words));
    EXPECT_EQ(check.status, 1) << check.said;
    EXPECT_EQ(check.cause(), check::causes::host_counters) << check.said;
    EXPECT_NE(check.sentence().find("depends on the step time TIME(1): "), std::string::npos) << check.sentence();
    EXPECT_EQ(check.sentence().find("KINC:"), std::string::npos) << check.sentence();
    EXPECT_EQ(check.found["diagnosis"].size(), 1u) << check.said;
  }
  const ForeignCheck once("umat_kinematic", kinematic("BEGINS_ONCE"));
  EXPECT_EQ(once.status, 0) << once.said;
  EXPECT_EQ(once.verdict_of(host_test), "pass");
}

TEST_F(Host, ACounterIsNotNamedForAnother) {
  const ForeignCheck check("umat_kinematic", kinematic("SETS_UP_AGAIN"));
  EXPECT_EQ(check.sentence().find("TIME(1)"), std::string::npos) << check.sentence();
}

TEST_F(Host, ACounterThatTheStateKeepsIsARemark) {
  const ForeignCheck check("umat_kinematic", kinematic("KEEPS_KINC"));
  EXPECT_EQ(check.status, 0) << check.said;
  EXPECT_NE(check.sentence_of(host_test).find("the state keeps KINC"), std::string::npos) << check.said;
}

TEST_F(LongHost, ATableByElementIsOneAndAKeyChoosesItsLine) {
  const ForeignCheck check("umat_kinematic", kinematic("BY_TABLE"));
  EXPECT_EQ(check.status, 0) << check.said;
  EXPECT_EQ(check.dependence_on("NOEL").substr(0, 20), "a table by element: ") << check.said;
  EXPECT_NE(check.sentence_of(host_test).find("`noel:`"), std::string::npos) << check.sentence_of(host_test);
  const ForeignCheck other("umat_kinematic", kinematic("BY_TABLE", "noel: 7\n"));
  EXPECT_EQ(other.status, 0) << other.said;
  EXPECT_NE(other.dependence_on("NOEL"), "") << "some lines are others still: " << other.said;
}

TEST_F(LongHost, AVumatIsTriedWithWhatItIsHanded) {
  const std::pair<const char*, const char*> all[] = {
      {"LENGTH", "charLength"}, {"PLACE", "coordMp"}, {"WARMTH", "tempOld and tempNew"}, {"DENSITY", "density"}};
  for (const auto& [words, name] : all) {
    const ForeignCheck check("vumat_j2", vumat(words));
    EXPECT_EQ(check.status, 0) << check.said;
    EXPECT_NE(check.dependence_on(name), "") << check.said;
  }
  const ForeignCheck right("vumat_j2", vumat("ASSAY"));
  EXPECT_EQ(right.status, 0) << right.said;
  EXPECT_FALSE(right.found.contains("depends_on")) << right.said;
  const ForeignCheck timed("vumat_j2", vumat("STEP_TIME"));
  EXPECT_EQ(timed.status, 1) << timed.said;
  EXPECT_EQ(timed.cause(), check::causes::host_counters) << timed.said;
}

}  // namespace
}  // namespace assay::drivers::test_check_host
