// SPDX-License-Identifier: BSD-3-Clause
// UMATs that are right only by what memory happens to hold: an output or a local variable is read before it is set.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "harness/check/battery.hpp"
#include "tests/drivers/foreign_checks.hpp"
#include "tests/drivers/process.hpp"

namespace assay::drivers::test_check_unset {
namespace {

const std::string head = R"(      SUBROUTINE UMAT(STRESS,STATEV,DDSDDE,SSE,SPD,SCD,RPL,DDSDDT,
     1 DRPLDE,DRPLDT,STRAN,DSTRAN,TIME,DTIME,TEMP,DTEMP,PREDEF,DPRED,
     2 CMNAME,NDI,NSHR,NTENS,NSTATV,PROPS,NPROPS,COORDS,DROT,PNEWDT,
     3 CELENT,DFGRD0,DFGRD1,NOEL,NPT,LAYER,KSPT,JSTEP,KINC)
      INCLUDE 'ABA_PARAM.INC'
      CHARACTER*80 CMNAME
      DIMENSION STRESS(NTENS),STATEV(NSTATV),DDSDDE(NTENS,NTENS),
     1 DDSDDT(NTENS),DRPLDE(NTENS),STRAN(NTENS),DSTRAN(NTENS),TIME(2),
     2 PREDEF(1),DPRED(1),PROPS(NPROPS),COORDS(3),DROT(3,3),
     3 DFGRD0(3,3),DFGRD1(3,3),JSTEP(4)
      DIMENSION C(6,6)
      G=PROPS(1)/(2.D0*(1.D0+PROPS(2)))
      BULK=PROPS(1)/(3.D0*(1.D0-2.D0*PROPS(2)))
)";

struct Unset {
  const char *name, *set, *use;
};

class UnsetMemory : public testing::TestWithParam<Unset> {};

TEST_P(UnsetMemory, IsHiddenStateAndTheSameSetBeforePasses) {
  if (!has_foreign("umat_kinematic")) GTEST_SKIP() << "no Fortran compiler";
  const ScratchFolder scratch;
  for (const bool is_set : {false, true}) {
    const std::string file = scratch.write(is_set ? "good.f" : "bad.f",
                                           head + (is_set ? GetParam().set : "") + GetParam().use + "      END\n");
    const Ending check =
        assay({"check", file, "--props", "1e3,.3", "--quick", "--json", scratch / "c.json", "-o", scratch / "r"});
    const auto found = nlohmann::json::parse(bytes_of(scratch / "c.json"));
    EXPECT_EQ(check.status, is_set ? 0 : 1) << check.said;
    if (is_set) continue;
    ASSERT_FALSE(found["diagnosis"].empty()) << check.said;
    EXPECT_EQ(found["diagnosis"][0]["cause"], check::causes::hidden_state) << check.said;
    EXPECT_NE(found["diagnosis"][0]["sentence"].get<std::string>().find("read before it is set"), std::string::npos)
        << check.said;
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, UnsetMemory,
                         testing::Values(Unset{"tangent", "      DDSDDE=0.D0\n",
                                               "      C=0.D0\n"
                                               "      C(1:3,1:3)=BULK-2.D0*G/3.D0\n"
                                               "      DO I=1,3\n"
                                               "        C(I,I)=C(I,I)+2.D0*G\n"
                                               "        C(I+3,I+3)=G\n"
                                               "      END DO\n"
                                               "      DDSDDE=DDSDDE+C\n"
                                               "      STRESS=STRESS+MATMUL(C,DSTRAN)\n"},
                                         Unset{"moduli", "      DDSDDE=0.D0\n",
                                               "      DDSDDE(1:3,1:3)=DDSDDE(1:3,1:3)+BULK-2.D0*G/3.D0\n"
                                               "      DO I=1,3\n"
                                               "        DDSDDE(I,I)=DDSDDE(I,I)+2.D0*G\n"
                                               "        DDSDDE(I+3,I+3)=DDSDDE(I+3,I+3)+G\n"
                                               "      END DO\n"
                                               "      STRESS=STRESS+MATMUL(DDSDDE,DSTRAN)\n"},
                                         Unset{"local_matrix", "      C=0.D0\n",
                                               "      C(1:3,1:3)=BULK-2.D0*G/3.D0\n"
                                               "      DO I=1,3\n"
                                               "        C(I,I)=C(I,I)+2.D0*G\n"
                                               "        C(I+3,I+3)=G\n"
                                               "      END DO\n"
                                               "      DDSDDE=C\n"
                                               "      STRESS=STRESS+MATMUL(C,DSTRAN)\n"},
                                         Unset{"local_row", "      C=0.D0\n",
                                               "      C(1,1:3)=BULK-2.D0*G/3.D0\n"
                                               "      C(1,1)=C(1,1)+2.D0*G\n"
                                               "      DO I=2,3\n"
                                               "        C(I,1:3)=C(1,2)\n"
                                               "        C(I,I)=C(1,1)\n"
                                               "      END DO\n"
                                               "      DO I=4,6\n"
                                               "        C(I,I)=G\n"
                                               "      END DO\n"
                                               "      DDSDDE=C\n"
                                               "      STRESS=STRESS+MATMUL(C,DSTRAN)\n"}),
                         [](const auto& instance) { return std::string(instance.param.name); });

/// CI reads files, and not what is printed on the way: with the source, and with the description made of it.
TEST(UnsetVariables, AreInTheFilesForCi) {
  if (!has_foreign("umat_kinematic")) GTEST_SKIP() << "no Fortran compiler";
  const ScratchFolder scratch;
  const std::string law = head + "      STRESS(1)=STRESS(1)+GG*DSTRAN(1)\n      END\n";
  const std::string file = scratch.write("law.f", law);
  const std::string said = "is used uninitialized";
  for (const std::vector<std::string>& subject :
       {std::vector<std::string>{file, "--props", "1e3,.3"}, {scratch / "r/law.yaml"}}) {
    std::vector<std::string> words{"check",   subject[0],        "--quick", "--json",     scratch / "c.json",
                                   "--junit", scratch / "c.xml", "-o",      scratch / "r"};
    words.insert(words.end(), subject.begin() + 1, subject.end());
    const Ending check = assay(words);
    const auto found = nlohmann::json::parse(bytes_of(scratch / "c.json"));
    ASSERT_EQ(found["warnings"].size(), 1u) << check.said;
    EXPECT_NE(found["warnings"][0].get<std::string>().find("law.f:"), std::string::npos) << found["warnings"];
    EXPECT_NE(found["warnings"][0].get<std::string>().find(said), std::string::npos) << found["warnings"];
    EXPECT_NE(bytes_of(scratch / "c.xml").find("<property name=\"warning\""), std::string::npos);
    EXPECT_NE(check.said.find("1 warning"), std::string::npos) << check.said;
  }
}

}  // namespace
}  // namespace assay::drivers::test_check_unset
