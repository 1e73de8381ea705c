// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/fortran_text.hpp"

#include <gtest/gtest.h>

#include "tests/drivers/material/fortran_texts.hpp"

namespace assay::drivers::test_fortran_routines {
namespace {

std::vector<FortranStatement> read(const std::string& text, FortranForm form = FortranForm::fixed) {
  return statements_of(lines_of_source(text), form);
}

/// "largest", "+" where that is all, "-" where it is not used.
std::string use(const std::string& statements, const std::string& array = "props") {
  const ArrayUse found = use_of(read(indented(statements)), array);
  return found.used ? std::to_string(found.largest) + (found.whole ? "+" : "") : "-";
}

TEST(FortranRoutines, SubroutinesHaveNamesAndArguments) {
  const auto all = subroutines_of(
      read("      SUBROUTINE A\n      X=1\n      END\n" + hooke_umat + "      FUNCTION F(X)\n      F=1\n      END\n"));
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].name, "a");
  EXPECT_TRUE(all[0].arguments.empty());
  EXPECT_EQ(all[1].name, "umat");
  EXPECT_EQ(all[1].arguments.size(), 37u);
  EXPECT_EQ(all[1].arguments[23], "props");
  EXPECT_EQ(all[1].line, 4);
  EXPECT_EQ(all[1].last_line, static_cast<int>(lines_of_source(hooke_umat).size()) + 3);
}

TEST(FortranRoutines, ModulesAndInnerOnesCount) {
  const auto all =
      subroutines_of(read("module m\ncontains\npure recursive subroutine inner(a, b)\nend subroutine inner\n"
                          "end module\nsubroutine outer()\ncontains\nsubroutine c(x)\nend subroutine\nend\n",
                          FortranForm::free));
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].name + all[1].name + all[2].name, "innerouterc");
  EXPECT_EQ(all[0].arguments.size(), 2u);
  EXPECT_EQ(all[1].arguments.size(), 0u);
}

TEST(FortranRoutines, UsesAreWhatIsExecuted) {
  EXPECT_EQ(use("DIMENSION PROPS(NPROPS)\nREAL*8 PROPS(9)\nreal(8), intent(in) :: props(8)"), "-");
  EXPECT_EQ(use("A=PROPS(3)\nIF (PROPS(12).GT.0) B=PROPS(1)"), "12+");
  EXPECT_EQ(use("DO I=1,NPROPS\nA=MYPROPS(9)\nPROPSX=PROPS_Y(8)"), "-") << "other names";
  EXPECT_EQ(use("A=PROPS(I)+PROPS(2)"), "2");
  EXPECT_EQ(use("CALL F(PROPS,NPROPS)\nA=PROPS(2)"), "2");
  EXPECT_EQ(use("CALL F(PROPS(2))"), "2") << "what is behind it may be read";
  EXPECT_EQ(use("IF (X.GT.0) CALL F(A,PROPS(2),B)"), "2");
  EXPECT_EQ(use("CALL F(PROPS(2)*2)"), "2+");
  EXPECT_EQ(use("CALL F(PROPS(1:6))"), "6+");
  EXPECT_EQ(use("A=MAX(PROPS(4),1.D0)"), "4+");
  EXPECT_EQ(use("A=PROPS(2*3)"), "0");
  EXPECT_EQ(use("REALPART=PROPS(5)"), "5+") << "no declaration";
  EXPECT_EQ(use("WRITE(6,*) 'PROPS(9)'\nA=PROPS(1) ! PROPS(8)"), "1+");
  EXPECT_EQ(use("S(K,1)=STATENEW(K,7)", "statenew"), "7+") << "the last index";
}

TEST(FortranRoutines, DeclarationsHaveTypesAndBytes) {
  const auto all =
      variables_of(read(indented("INTEGER*8 NDI, NSHR\nREAL STRESS(6)\nDOUBLE PRECISION X\nREAL(KIND=8) Y\n"
                                 "real(dp), dimension(3), intent(in) :: z, w(2)\ninteger(4)::i=1\n"
                                 "INTEGERX=5\nREALX(1)=2")));
  std::string text;
  for (const FortranVariable& v : all) text += v.name + " " + v.type + " " + std::to_string(v.bytes) + "|";
  EXPECT_EQ(text,
            "ndi integer 8|nshr integer 8|stress real 4|x doubleprecision 8|y real 8|z real 0|w real 0|i integer 4|");
}

TEST(FortranRoutines, IncludesAreFoundInBothWords) {
  const auto all = includes_of(lines_of_source("      INCLUDE 'ABA_PARAM.INC'\n#include <SMAAspUserSubroutines.hdr>\n"
                                               "#  include \"own.h\"\nC     INCLUDE 'NOT.INC'\n      include\"b.f\"\n"
                                               "      INCLUDED = 'x'\n      INCLUDE(1) = 'y'\n"),
                               FortranForm::fixed);
  std::string text;
  for (const FortranInclude& each : all) text += std::to_string(each.line) + " " + each.name + "|";
  EXPECT_EQ(text, "1 ABA_PARAM.INC|2 SMAAspUserSubroutines.hdr|3 own.h|5 b.f|");
}

}  // namespace
}  // namespace assay::drivers::test_fortran_routines
