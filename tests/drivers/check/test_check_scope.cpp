// SPDX-License-Identifier: BSD-3-Clause
// UMATs by which a check was passed, or named wrongly, because it did not see where the model stops, swells or counts.
#include <gtest/gtest.h>

#include "tests/drivers/material/source_fixture.hpp"
#include "tests/drivers/process.hpp"

namespace assay::drivers::test_check_scope {
namespace {

/// What the program says of Hooke's law with more lines after the stress is known.
class CheckScope : public SourceTest {
 protected:
  Ending check(const std::string& lines, const std::vector<std::string>& more = {}) const {
    const std::string file = scratch.write("model.f", umat(lines));
    std::vector<std::string> words{"check", file,      "--props", "210e3,.3,250",   "--statev",
                                   "1",     "--quick", "-o",      scratch / "check"};
    words.insert(words.end(), more.begin(), more.end());
    Ending ending = assay(words);
    for (std::size_t at; (at = ending.said.find("\n    ")) != std::string::npos;) ending.said.replace(at, 5, " ");
    return ending;
  }

  static bool says(const Ending& ending, const std::string& words) {
    return ending.said.find(words) != std::string::npos;
  }

  static std::string umat(const std::string& lines) {
    return "      SUBROUTINE UMAT(STRESS,STATEV,DDSDDE,SSE,SPD,SCD,RPL,DDSDDT,\n"
           "     1 DRPLDE,DRPLDT,STRAN,DSTRAN,TIME,DTIME,TEMP,DTEMP,PREDEF,DPRED,\n"
           "     2 CMNAME,NDI,NSHR,NTENS,NSTATV,PROPS,NPROPS,COORDS,DROT,PNEWDT,\n"
           "     3 CELENT,DFGRD0,DFGRD1,NOEL,NPT,LAYER,KSPT,KSTEP,KINC)\n"
           "      INCLUDE 'ABA_PARAM.INC'\n"
           "      CHARACTER*80 CMNAME\n"
           "      DIMENSION STRESS(NTENS),STATEV(NSTATV),DDSDDE(NTENS,NTENS),\n"
           "     1 DSTRAN(NTENS),TIME(2),PREDEF(1),PROPS(NPROPS)\n"
           "      AMU=PROPS(1)/2/(1+PROPS(2))\n"
           "      ALAM=PROPS(1)*PROPS(2)/(1+PROPS(2))/(1-2*PROPS(2))\n"
           "      DDSDDE=0\n"
           "      DDSDDE(1:3,1:3)=ALAM\n"
           "      DO I=1,3\n"
           "        DDSDDE(I,I)=ALAM+2*AMU\n"
           "        DDSDDE(I+3,I+3)=AMU\n"
           "      END DO\n"
           "      STRESS=STRESS+MATMUL(DDSDDE,DSTRAN)\n" +
           lines + "      END\n";
  }
};
using LongCheckScope = CheckScope;

constexpr const char* missing = "      IF (MAXVAL(ABS(STRESS)).GT.PROPS(3)) CALL PLRET(STRESS)\n";
constexpr const char* refusing = "      IF (MAXVAL(ABS(STRESS)).GT.PROPS(3)) PNEWDT=0.25D0\n";

TEST_F(LongCheckScope, ARoutineThatIsMissingFailsByName) {
  for (const std::vector<std::string>& more : {std::vector<std::string>{}, {"--strain", "0.05"}}) {
    const Ending ending = check(missing, more);
    EXPECT_EQ(ending.status, 1) << ending.said;
    EXPECT_TRUE(says(ending, "diagnosis: routine missing")) << ending.said;
    EXPECT_TRUE(says(ending, "plret_")) << ending.said;
  }
}

TEST_F(LongCheckScope, AModelThatRefusesEveryPlasticStepDoesNotPassInSilence) {
  const Ending usual = check(refusing);
  EXPECT_EQ(usual.status, 0) << usual.said;
  EXPECT_TRUE(says(usual, "(it refuses them)")) << usual.said;
  const Ending asked = check(refusing, {"--strain", "0.05"});
  EXPECT_EQ(asked.status, 1) << asked.said;
  EXPECT_TRUE(says(asked, "diagnosis: strain not reached")) << asked.said;
}

TEST_F(LongCheckScope, AStressThatNobodyMakesIsNone) {
  for (const char* lines :
       {"      STRESS=0\n", "      IF (PREDEF(1).LT.0.5D0) STRESS=STRESS-MATMUL(DDSDDE,DSTRAN)\n"}) {
    const Ending ending = check(lines);
    EXPECT_EQ(ending.status, 1) << ending.said;
    EXPECT_TRUE(says(ending, "diagnosis: no stress")) << ending.said;
    EXPECT_FALSE(says(ending, "wrong spin")) << ending.said;
  }
}

TEST_F(LongCheckScope, AStrainOfItsOwnIsNoSmallStrainLaw) {
  const Ending ending = check("      STRESS(1:3)=STRESS(1:3)-0.1D0*DTIME*(3*ALAM+2*AMU)\n");
  EXPECT_EQ(ending.status, 1) << ending.said;
  EXPECT_TRUE(says(ending, "diagnosis: strain of its own in time")) << ending.said;
  EXPECT_TRUE(says(ending, "flags: [grows]")) << ending.said;
  EXPECT_FALSE(says(ending, "small-strain")) << ending.said;
}

/// The flag alone is enough, as the diagnosis says.
TEST_F(CheckScope, WhatGrowsPassesWhereItIsDeclared) {
  scratch.write("model.f", umat("      STRESS(1:3)=STRESS(1:3)-0.1D0*DTIME*(3*ALAM+2*AMU)\n"));
  const std::string declared = scratch.write(
      "grows.yaml", "source: model.f\ninterface: umat\nproperties: [210e3, 0.3, 250]\nstate: 1\nflags: [grows]\n");
  const Ending ending = assay({"check", declared, "--quick", "-o", scratch / "check"});
  EXPECT_EQ(ending.status, 0) << ending.said;
}

TEST_F(LongCheckScope, TheLengthOfAStepIsToldFromItsStrain) {
  for (const char* lines : {"      IF (DTIME.GT.0.75D0) PNEWDT=0.5D0\n", "      IF (DTIME.GT.1.D-5) CALL XIT\n"}) {
    const Ending ending = check(lines);
    EXPECT_EQ(ending.status, 0) << ending.said;
    EXPECT_TRUE(says(ending, "not tested:") && says(ending, "steps above")) << ending.said;
    EXPECT_EQ(check(lines, {"--step", "1e-5"}).status, 0);
    const Ending long_ones = check(lines, {"--step", "2"});
    EXPECT_EQ(long_ones.status, 1) << long_ones.said;
    EXPECT_TRUE(says(long_ones, "diagnosis: refuses the length of a step")) << long_ones.said;
  }
}

TEST_F(CheckScope, ADoubledShearModulusIsNotTestedAndSaid) {
  const Ending ending = check("      CONTINUE\n");
  EXPECT_EQ(ending.status, 0) << ending.said;
  EXPECT_TRUE(says(ending, "whether the values of the parameters are right (there is no reference)")) << ending.said;
  EXPECT_TRUE(says(ending, "other temperatures")) << ending.said;
}

}  // namespace
}  // namespace assay::drivers::test_check_scope
