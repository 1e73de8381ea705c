// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/fortran_messages.hpp"

#include <gtest/gtest.h>

#include "drivers/material/fortran_compiler.hpp"
#include "drivers/text/words.hpp"
#include "tests/drivers/material/source_fixture.hpp"

namespace assay::drivers::test_fortran_messages {
namespace {

TEST(CompilerMessages, OfVariablesOfTheCompilersOwnAreNotTold) {
  EXPECT_TRUE(warnings_in("m.f:9:72: Warning: '__var_1_mmb.offset' is used uninitialized [-Wuninitialized]\n").empty());
  EXPECT_EQ(warnings_in("m.f:9:72: Warning: 'anu' is used uninitialized [-Wuninitialized]\n").size(), 1u);
}

class FortranMessages : public SourceTest {
 protected:
  /// Of a UMAT with these statements, or of a whole source.
  std::string warnings(const std::string& text, const std::string& name = "m.f") {
    const std::string whole = text.starts_with("      SUBROUTINE") ? text : fixed_umat(text);
    const FortranSource source = read_fortran_source(scratch.write(name, whole), {}, "source");
    std::string all;
    for (const std::string& each : library_of_source(source).warnings) all += each + "\n";
    return all;
  }
};
using LongFortranMessages = FortranMessages;

TEST_F(LongFortranMessages, IntegersByTheirLetterThatTakeRealsAreNamed) {
  const std::string two = warnings(
      "      REAL*8 NU\n      E=PROPS(1)\n      NU=PROPS(2)\n      MU=E/(2.D0*(1.D0+NU))\n"
      "      LAM=E*NU/((1.D0+NU)*\n     1 (1.D0-2.D0*NU))\n      STRESS(1)=MU+LAM\n");
  EXPECT_NE(two.find("m.f:16: MU, LAM are integers by their first letter, and take real numbers: digits after"),
            std::string::npos)
      << two;
  const std::string one = warnings("      IF (PROPS(1).GT.0.D0) KAPPA=PROPS(1)/3\n      STRESS(1)=KAPPA\n");
  EXPECT_NE(one.find("KAPPA is an integer by its first letter, and takes a real number"), std::string::npos) << one;
  const std::string array = warnings("      DIMENSION NV(3)\n      NV(2)=STRESS(1)\n      STRESS(1)=NV(2)\n");
  EXPECT_NE(array.find("NV is an integer"), std::string::npos) << array;
}

TEST_F(LongFortranMessages, NoOthersAre) {
  for (const char* right :
       {"      INTEGER MU\n      MU=PROPS(1)\n      STRESS(1)=MU\n",
        "      MU=INT(PROPS(1))\n      LAM=NINT(PROPS(2))\n      STRESS(1)=MU+LAM\n",
        "      DO 10 K=1,NTENS\n      I=K/2\n   10 STRESS(I+1)=K\n", "      REAL*8 LAM\n      LAM=PROPS(1)\n",
        "      REAL E\n      E=STRESS(1)\n      STRESS(1)=E\n"}) {
    EXPECT_EQ(warnings(right), "") << right;
  }
}

/// A declaration of another routine is none of this one, and one of the host is.
TEST_F(FortranMessages, ADeclarationHoldsInItsScope) {
  const std::string helper = "      SUBROUTINE OTHER(A)\n      INTEGER MU\n      MU=1\n      A=MU\n      END\n";
  const std::string apart = warnings(fixed_umat("      MU=PROPS(1)\n      STRESS(1)=MU\n") + helper);
  EXPECT_NE(apart.find("MU is an integer"), std::string::npos) << apart;
  std::string host = fixed_umat("      INTEGER MU\n      CALL INNER\n      STRESS(1)=MU\n");
  host.replace(host.find("      RETURN\n      END\n"), std::string::npos,
               "      CONTAINS\n      SUBROUTINE INNER\n      MU=PROPS(1)\n      END SUBROUTINE\n      END\n");
  EXPECT_EQ(warnings(host), "");
}

}  // namespace
}  // namespace assay::drivers::test_fortran_messages
