// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/fortran_text.hpp"

#include <gtest/gtest.h>

namespace assay::drivers::test_fortran_text {
namespace {

using Form = FortranForm;

std::string statements(const std::string& text, Form form) {
  std::string all;
  for (const FortranStatement& each : statements_of(lines_of_source(text), form)) {
    all += std::to_string(each.line) + " " + each.text + "|";
  }
  return all;
}

TEST(FortranText, LinesEndAsTheyDoAnywhere) {
  EXPECT_EQ(lines_of_source("\xEF\xBB\xBF"
                            "a\r\nb\n\nc"),
            (std::vector<std::string>{"a", "b", "", "c"}));
  EXPECT_TRUE(lines_of_source("").empty());
}

TEST(FortranText, FixedFormHasLabelsMarksAndComments) {
  EXPECT_EQ(statements("C     comment\n"
                       "   10 A = 1\n"
                       "     & + 2  ! more\n"
                       "*     another\n"
                       "     0B = 'It''s; not' ; C = 3\n"
                       "d     debugging\n"
                       "      ! a comment by itself\n"
                       "#ifdef X\n"
                       "\tD = 4\n"
                       "\t1 + 5\n",
                       Form::fixed),
            "2 a=1+2|5 b=''''|5 c=3|9 d=4+5|");
}

TEST(FortranText, FreeFormGoesOnByItsMarks) {
  EXPECT_EQ(
      statements("call A(x, & ! first\n\n  ! between\n  & y)\n10 b = \"a ! b\" // 'c'; return\nd = 'x&\n   &y!z'\n",
                 Form::free),
      "1 calla(x,y)|5 b=\"\"//''|5 return|6 d=''|");
}

TEST(FortranText, FixedFormIsReadAsFarAsTheReaderGoes) {
  const std::string line = "      A = 1" + std::string(61, ' ') + "+ 2";
  EXPECT_EQ(line.find('+'), standard_columns);
  FortranCode narrow(Form::fixed, standard_columns), wide(Form::fixed);
  EXPECT_EQ(narrow.of(line), "      A = 1");
  EXPECT_EQ(wide.of(line), line);
}

TEST(FortranText, AQuoteThatIsOpenHoldsNoComment) {
  FortranCode reader(Form::fixed);
  EXPECT_EQ(reader.of("      WRITE(6,*) 'not ! a"), "      WRITE(6,*) 'not ! a");
  EXPECT_EQ(reader.of("     1 comment ! yet' ! but this"), "     1 comment ! yet'");
  EXPECT_EQ(reader.of("C     don't"), "");
  EXPECT_EQ(reader.of("      X = 1 ! it's"), "      X = 1");
  EXPECT_EQ(reader.of("      Y = 2 ! plain"), "      Y = 2") << "what a comment opens is not open";
}

}  // namespace
}  // namespace assay::drivers::test_fortran_text
