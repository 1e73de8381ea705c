// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/check/check_foreign.hpp"

#include <gtest/gtest.h>

#include "tests/drivers/foreign_checks.hpp"

namespace assay::drivers::test_check_beyond {
namespace {

using adapters::GuardedArrays;

/// Of the kinematic double, in MPa: the yield stress is 250.
std::string kinematic(const std::string& state, const std::string& words = "ASSAY",
                      const std::string& properties = "[2.1e5, 0.3, 250, 1000]") {
  return "interface: umat\nunits: {stress: MPa}\nflags: [non_smooth]\nproperties: " + properties +
         "\nmaterial_name: " + words + "\n" + (state.empty() ? "" : "state: " + state + "\n");
}

class Beyond : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_foreign("umat_kinematic")) GTEST_SKIP() << "no Fortran compiler";
  }
};
using LongBeyond = Beyond;

TEST_F(Beyond, AStateThatNobodyHasDeclaredIsAskedFor) {
  for (const char* words : {"ASSAY", "UNTURNED"}) {
    const ForeignCheck check("umat_kinematic", kinematic("", words));
    EXPECT_EQ(check.status, 1) << check.said;
    EXPECT_EQ(check.cause(), check::causes::state_undeclared) << check.said;
    EXPECT_NE(check.sentence().find("reads STATEV(1:6)"), std::string::npos) << check.sentence();
    EXPECT_NE(check.sentence().find("none is declared: write `state: 7`"), std::string::npos) << check.sentence();
    EXPECT_EQ(check.found["diagnosis"].size(), 1u) << check.said;
  }
}

TEST_F(Beyond, AStateOfTooFewNumbersIsCounted) {
  const ForeignCheck check("umat_kinematic", kinematic("4"));
  EXPECT_EQ(check.cause(), check::causes::state_undeclared) << check.said;
  EXPECT_NE(check.sentence().find("reads STATEV(5:6)"), std::string::npos) << check.sentence();
  EXPECT_NE(check.sentence().find("4 are declared: `state` must declare 7 numbers"), std::string::npos)
      << check.sentence();
  const ForeignCheck two("umat_kinematic", kinematic("{back_stress: symmetric_tensor, p: scalar}", "TWO_TENSORS"));
  EXPECT_EQ(two.cause(), check::causes::state_undeclared) << two.said;
  EXPECT_NE(two.sentence().find("STATEV(8:13)"), std::string::npos) << two.sentence();
}

TEST_F(Beyond, APropertyThatIsMissingIsCounted) {
  const ForeignCheck check("umat_kinematic", kinematic("7", "MORE_PROPS"));
  EXPECT_EQ(check.status, 1) << check.said;
  EXPECT_EQ(check.cause(), check::causes::properties_missing) << check.said;
  EXPECT_NE(check.sentence().find("reads PROPS(5), 4 are given: `properties` must give 5"), std::string::npos)
      << check.sentence();
  const ForeignCheck none("umat_neo_hookean", "interface: umat\n");
  EXPECT_EQ(none.cause(), check::causes::properties_missing) << none.said;
  EXPECT_NE(none.sentence().find("reads PROPS(1:2), none is given"), std::string::npos) << none.sentence();
}

TEST_F(Beyond, BothAreTold) {
  const ForeignCheck check("umat_kinematic", kinematic("", "MORE_PROPS"));
  ASSERT_EQ(check.found["diagnosis"].size(), 2u) << check.said;
  EXPECT_NE(check.sentence_of(beyond_test).find("PROPS(5)"), std::string::npos) << check.said;
  EXPECT_NE(check.sentence_of(beyond_test).find("STATEV(1:6)"), std::string::npos) << check.said;
}

TEST_F(Beyond, AVumatIsLookedAtToo) {
  const std::string keys = "interface: vumat\nflags: [non_smooth]\nproperties: {E: 1.0e3, nu: 0.3, yield: 10, H: 20}\n";
  const ForeignCheck check("vumat_j2", keys);
  EXPECT_EQ(check.status, 1) << check.said;
  EXPECT_EQ(check.cause(), check::causes::state_undeclared) << check.said;
  EXPECT_NE(check.sentence().find("reads stateOld(1) and writes stateNew(1), none is declared: write `state: 1`"),
            std::string::npos)
      << check.sentence();
  const ForeignCheck three("vumat_j2", "interface: vumat\nproperties: {E: 1.0e3, nu: 0.3, yield: 10}\nstate: 1\n");
  EXPECT_EQ(three.cause(), check::causes::properties_missing) << three.said;
  EXPECT_NE(three.sentence().find("reads props(4), 3 are given"), std::string::npos) << three.sentence();
}

TEST_F(Beyond, AStateThatIsLeftInSomeStepsIsAnOverrun) {
  const std::string keys =
      "interface: vumat\nflags: [non_smooth]\nproperties: {E: 1.0e3, nu: 0.3, yield: 10, H: 20}\nstate: 1\n";
  const ForeignCheck left("vumat_j2", keys + "material_name: FLOWING\n");
  EXPECT_EQ(left.status, 1) << left.said;
  EXPECT_EQ(left.cause(), check::causes::overrun) << left.said;
  EXPECT_NE(left.sentence().find("leaves stateNew(1) unwritten in some steps"), std::string::npos) << left.sentence();
  EXPECT_EQ(ForeignCheck("vumat_j2", keys).status, 0);
}

TEST_F(LongBeyond, WhatIsDeclaredPassesAndItsReplayTellsTheSameAgain) {
  const ForeignCheck right("umat_kinematic", kinematic("{back_stress: symmetric_tensor, p: scalar}"));
  EXPECT_EQ(right.status, 0) << right.said;
  EXPECT_EQ(right.verdict_of(beyond_test), "pass") << right.said;
  const ScratchFolder scratch;
  const std::string model = scratch.write(
      "wrong.yaml", "library: " + built("tests/foreign/umat_kinematic.so") + "\ndensity: 1000\n" + kinematic(""));
  ASSERT_EQ(assay({"check", model, "--quick", "-o", scratch / "r"}).status, 1);
  const Ending again = assay({"check", "--replay", scratch / "r/wrong.calls.beyond.yaml"});
  EXPECT_EQ(again.status, 1);
  EXPECT_NE(again.said.find("state not declared"), std::string::npos) << again.said;
}

TEST(BeyondWords, JoinWhatFollowsEachOther) {
  EXPECT_EQ(ranges_of({5}), "5");
  EXPECT_EQ(ranges_of({1, 2, 3, 4, 7}), "1:4, 7");
  EXPECT_EQ(ranges_of({-1, 0, 8, 9}), "-1:0, 8:9");
}

TEST(BeyondWords, OfOtherArraysAreAnOverrun) {
  const ForeignFinding strain = judged_beyond({{{"STRAN", 4, 5}, {"STRAN", 4, 6}}, {}});
  EXPECT_EQ(strain.test.cause, check::causes::overrun);
  EXPECT_EQ(strain.test.sentence, "reads STRAN(5:6) of STRAN, which has 4 components");
  EXPECT_EQ(judged_beyond({{{"STATEV", 7, 0}}, {}}).test.cause, check::causes::overrun) << "before its first";
  EXPECT_EQ(judged_beyond({}).test.verdict, check::Verdict::pass);
}

Beyonds read_of(const char* array, std::size_t size, std::ptrdiff_t first, std::ptrdiff_t last) {
  Beyonds found;
  for (std::ptrdiff_t k = first; k <= last; ++k) found.read.push_back({array, size, k});
  return found;
}

/// LS-DYNA with IHYPER keeps F right behind hsv.
TEST(BeyondWords, NineNumbersBehindTheHistoryMayBeF) {
  const auto sentence = [](const Beyonds& found, bool may_be_F) {
    return judged_beyond(found, may_be_F).test.sentence;
  };
  EXPECT_EQ(sentence(read_of("hsv", 1, 2, 10), true),
            "reads hsv(2:10), 1 is declared: F stands there with IHYPER = 1: declare `strain: finite`; if it is not F "
            "that is read, `state` must declare 10 numbers");
  Beyonds most;
  for (const std::ptrdiff_t k : {3, 4, 6, 7, 9, 10}) most.read.push_back({"hsv", 1, k});
  EXPECT_NE(sentence(most, true).find("declare `strain: finite`"), std::string::npos);
  EXPECT_NE(sentence(read_of("hsv", 0, 1, 9), true).find("declare `strain: finite`"), std::string::npos);
  EXPECT_EQ(sentence(read_of("hsv", 1, 2, 9), true), "reads hsv(2:9), 1 is declared: `state` must declare 9 numbers");
  EXPECT_EQ(sentence(read_of("hsv", 1, 3, 11), true).find("strain: finite"), std::string::npos) << "not right behind";
  EXPECT_EQ(sentence(read_of("hsv", 1, 2, 10), false).find("strain: finite"), std::string::npos) << "it is declared";
  Beyonds written = read_of("hsv", 1, 2, 10);
  written.written = {{"hsv", 1, 2}};
  EXPECT_EQ(sentence(written, true).find("strain: finite"), std::string::npos) << "nobody writes to F";
}

TEST(BeyondWords, OfWhatIsOnlyWrittenAreAnOverrunToo) {
  const ForeignFinding state = judged_beyond({{}, {{"STATEV", 1, 2}, {"STATEV", 1, 3}}});
  EXPECT_EQ(state.test.cause, check::causes::overrun);
  EXPECT_EQ(state.test.sentence, "writes STATEV(2:3), 1 is declared: `state` must declare 3 numbers");
  EXPECT_EQ(judged_beyond({{}, {}, {2, 3, 4}}).test.cause, check::causes::overrun);
  EXPECT_EQ(judged_beyond({{}, {}, {2, 3, 4}}).test.sentence.substr(0, 44),
            "leaves stateNew(2:4) unwritten in some steps");
  EXPECT_EQ(judged_beyond({{}, {{"STRESS", 6, 7}}}).test.sentence,
            "writes STRESS(7) of STRESS, which has 6 components");
}

}  // namespace
}  // namespace assay::drivers::test_check_beyond
