// SPDX-License-Identifier: BSD-3-Clause
// UMATs that are right only by what memory happens to hold: an output or a local variable is read before it is set.
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "harness/check/battery.hpp"
#include "tests/drivers/foreign_checks.hpp"
#include "tests/drivers/process.hpp"
#include "tests/support/built.hpp"
#include "tests/support/some_of.hpp"

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
      DIMENSION C(6,6),E(4),A(NTENS,NTENS)
      LOGICAL STIFF(6)
      G=PROPS(1)/(2.D0*(1.D0+PROPS(2)))
      BULK=PROPS(1)/(3.D0*(1.D0-2.D0*PROPS(2)))
)";

/// C, E and STIFF lie in the stack; A, whose size the compiler does not know, in allocated memory.
struct Unset {
  const char *name, *set, *use;
};

class UnsetMemory : public testing::TestWithParam<Unset> {
 protected:
  void SetUp() override {
    if (!has_foreign("umat_kinematic")) GTEST_SKIP() << "no Fortran compiler";
    if (sanitized() && std::string(GetParam().name).starts_with("heap"))
      GTEST_SKIP() << "the address sanitizer fills what is allocated";
  }

  std::string source(bool is_set) const {
    return scratch_.write(is_set ? "good.f" : "bad.f",
                          head + (is_set ? GetParam().set : "") + GetParam().use + "      END\n");
  }

  /// The first of the diagnosis.
  static nlohmann::json first_of(const std::string& file) {
    const auto found = nlohmann::json::parse(bytes_of(file));
    return found["diagnosis"].empty() ? nlohmann::json() : found["diagnosis"][0];
  }

  const ScratchFolder scratch_;
};

TEST_P(UnsetMemory, IsHiddenStateAndTheSameSetBeforePasses) {
  const std::string json = scratch_ / "c.json", results = scratch_ / "r";
  const Ending good = assay({"check", source(true), "--props", "1e3,.3", "--quick", "--json", json, "-o", results});
  EXPECT_EQ(good.status, 0) << good.said;
  const Ending bad = assay({"check", source(false), "--props", "1e3,.3", "--quick", "--json", json, "-o", results});
  EXPECT_EQ(bad.status, 1) << bad.said;
  const nlohmann::json found = first_of(json);
  ASSERT_FALSE(found.is_null()) << bad.said;
  EXPECT_EQ(found["cause"], check::causes::hidden_state) << bad.said;
  EXPECT_NE(found["sentence"].get<std::string>().find("read before it is set"), std::string::npos) << bad.said;
  if (sanitized()) return;                              // which must be loaded before any other library
  for (const char* byte : {"0", "63", "192", "255"}) {  // of a machine that has left it in the stack
    const auto leave = [byte] {
      ::setenv("LD_PRELOAD", built("tests/fill_stack.so").c_str(), 1);
      ::setenv("FILL_STACK", byte, 1);
    };
    // the description that is made of the source: it is not compiled again
    const Ending there = assay({"check", results + "/bad.yaml", "--quick", "--json", json, "-o", results}, leave);
    EXPECT_EQ(there.status, 1) << byte << ": " << there.said;
    EXPECT_EQ(first_of(json), found) << byte << ": " << there.said;
  }
}

const auto cases_of_unset_memory = one_of_each<UnsetMemory::ParamType>(
    4, testing::Values(Unset{"tangent", "      DDSDDE=0.D0\n",
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
                             "      STRESS=STRESS+MATMUL(C,DSTRAN)\n"},
                       Unset{"local_divisor", "      C=1.D0\n",
                             "      DDSDDE=0.D0\n"
                             "      DDSDDE(1:3,1:3)=BULK-2.D0*G/3.D0\n"
                             "      DO I=1,3\n"
                             "        DDSDDE(I,I)=DDSDDE(I,I)+2.D0*G\n"
                             "        DDSDDE(I+3,I+3)=G\n"
                             "      END DO\n"
                             "      DO I=1,NTENS\n"
                             "        S=0.D0\n"
                             "        DO J=1,NTENS\n"
                             "          S=S+DDSDDE(I,J)*DSTRAN(J)\n"
                             "        END DO\n"
                             "        STRESS(I)=STRESS(I)+S/C(I,I)\n"
                             "      END DO\n"},
                       Unset{"local_flag", "      STIFF=.FALSE.\n",
                             "      DDSDDE=0.D0\n"
                             "      DDSDDE(1:3,1:3)=BULK-2.D0*G/3.D0\n"
                             "      DO I=1,3\n"
                             "        DDSDDE(I,I)=DDSDDE(I,I)+2.D0*G\n"
                             "        DDSDDE(I+3,I+3)=G\n"
                             "      END DO\n"
                             "      DO I=1,NTENS\n"
                             "        IF (STRAN(I).GT.1.D3) STIFF(I)=.TRUE.\n"
                             "      END DO\n"
                             "      DO I=1,NTENS\n"
                             "        FACTOR=1.D0\n"
                             "        IF (STIFF(I)) FACTOR=2.D0\n"
                             "        DO J=1,NTENS\n"
                             "          STRESS(I)=STRESS(I)+FACTOR*DDSDDE(I,J)*DSTRAN(J)\n"
                             "        END DO\n"
                             "      END DO\n"},
                       Unset{"local_element_beyond", "      E=0.D0\n",
                             "      DDSDDE=0.D0\n"
                             "      DDSDDE(1:3,1:3)=BULK-2.D0*G/3.D0\n"
                             "      DO I=1,3\n"
                             "        DDSDDE(I,I)=DDSDDE(I,I)+2.D0*G\n"
                             "        DDSDDE(I+3,I+3)=G\n"
                             "      END DO\n"
                             "      DO I=1,NDI\n"
                             "        E(I)=DSTRAN(I)\n"
                             "      END DO\n"
                             "      TRACE=0.D0\n"
                             "      DO I=1,NDI+1\n"
                             "        TRACE=TRACE+E(I)\n"
                             "      END DO\n"
                             "      DO I=1,NDI\n"
                             "        STRESS(I)=STRESS(I)+(BULK-2.D0*G/3.D0)*TRACE\n"
                             "     1   +2.D0*G*DSTRAN(I)\n"
                             "      END DO\n"
                             "      DO I=NDI+1,NTENS\n"
                             "        STRESS(I)=STRESS(I)+G*DSTRAN(I)\n"
                             "      END DO\n"},
                       Unset{"heap_matrix", "      A=0.D0\n",
                             "      A(1:3,1:3)=BULK-2.D0*G/3.D0\n"
                             "      DO I=1,3\n"
                             "        A(I,I)=A(I,I)+2.D0*G\n"
                             "        A(I+3,I+3)=G\n"
                             "      END DO\n"
                             "      DDSDDE=A\n"
                             "      STRESS=STRESS+MATMUL(A,DSTRAN)\n"}));
const auto name_of_unset_memory = [](const auto& instance) { return std::string(instance.param.name); };
INSTANTIATE_TEST_SUITE_P(Kinds, UnsetMemory, testing::ValuesIn(cases_of_unset_memory.some), name_of_unset_memory);
INSTANTIATE_TEST_SUITE_P(LongKinds, UnsetMemory, testing::ValuesIn(cases_of_unset_memory.others), name_of_unset_memory);

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
