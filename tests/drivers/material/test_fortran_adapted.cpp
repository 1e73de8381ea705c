// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/fortran_text.hpp"

#include <gtest/gtest.h>

namespace assay::drivers::test_fortran_adapted {
namespace {

constexpr auto fixed = FortranForm::fixed, free = FortranForm::free;

std::string text(const std::vector<std::string>& lines) {
  std::string all;
  for (const std::string& line : lines) all += line + "\n";
  return all;
}

std::string adapted(const std::string& lines, FortranForm form) {
  const std::vector<std::string> all = lines_of_source(lines);
  return text(adapted_lines(all, std::vector<FortranForm>(all.size(), form)));
}

std::string freed(const std::string& lines) {
  const std::vector<std::string> all = lines_of_source(lines);
  return text(in_free_form(all, forms_of_lines(all, fixed)));
}

TEST(FortranAdapted, DirectivesOfThePreprocessorArePlain) {
  EXPECT_EQ(adapted("      #include 'ABA_PARAM.INC'\n#INCLUDE <A.HDR>\n  # Define A 'b'\n", fixed),
            "#include \"ABA_PARAM.INC\"\n#include <A.HDR>\n#define A 'b'\n");
  EXPECT_EQ(adapted("     #include,more\n      # a\n", fixed), "     #include,more\n      # a\n")
      << "a continuation, no word";
  EXPECT_EQ(adapted("     #include 'a'\n", free), "#include \"a\"\n");
}

TEST(FortranAdapted, AnAmpersandAtTheEndIsTakenOffInFixedForm) {
  const std::string pad(60, ' ');
  EXPECT_EQ(adapted("      A=1 &\n     & +2 & ! why\n      B='x &\n     &y'\n", fixed),
            "      A=1 \n     & +2 \n      B='x &\n     &y'\n");
  EXPECT_EQ(adapted("      CALL A(X," + pad + "&\n     &       Y)\n", fixed),
            "      CALL A(X," + pad + "\n     &       Y)\n");
  EXPECT_EQ(adapted("a = 1 &\n", free), "a = 1 &\n");
  EXPECT_EQ(adapted("     &\n", fixed), "     &\n") << "an empty continuation";
}

TEST(FortranAdapted, FixedPartsBecomeFree) {
  EXPECT_EQ(
      freed("C     words\n      A=T\n     &49 ! note\n*\n     1 +B\n!DEC$ FREEFORM\nx = 1 &\n  + 2\ncDEC$ NOFREEFORM\n"
            "   10 C=1\n"),
      "!     words\n      A=T&\n     &49&\n!\n     & +B\n!DEC$ FREEFORM\nx = 1 &\n  + 2\n!DEC$ NOFREEFORM\n   10 "
      "C=1\n");
}

TEST(FortranAdapted, StatementsStayTheSame) {
  const std::string source =
      "C     it's\n      CALL A('x ! y',\n     1 B)  ! don't\n      C=1\n     2 +D\n!DIR$ FREEFORM\ne = f & ! g\n & + "
      "h\n";
  const std::vector<std::string> lines = lines_of_source(source);
  std::string words;
  for (const auto& each : statements_of(in_free_form(lines, forms_of_lines(lines, fixed)), free)) {
    words += std::to_string(each.line) + " " + each.text + "|";
  }
  EXPECT_EQ(words, "2 calla('',b)|4 c=1+d|7 e=f+h|");
}

}  // namespace
}  // namespace assay::drivers::test_fortran_adapted
