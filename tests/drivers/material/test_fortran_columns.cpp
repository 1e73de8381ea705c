// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <regex>

#include "drivers/material/fortran_text.hpp"
#include "drivers/material/tool_process.hpp"
#include "tests/drivers/scratch_folder.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_fortran_columns {
namespace {

/// A line with more in a column, counted from 1.
std::string at_column(std::size_t column, std::string line, const std::string& more) {
  line.resize(column - 1, ' ');
  return line + more + "\n";
}

std::string numbers(const std::vector<LongLine>& lines) {
  std::string text;
  for (const LongLine& line : lines) text += std::to_string(line.line) + " " + line.beyond + "|";
  return text;
}

ColumnReadings readings(const std::string& text, FortranForm form = FortranForm::fixed) {
  return readings_of(lines_of_source(text), form);
}

TEST(FortranColumns, CodeBeyond72IsATail) {
  const ColumnReadings found =
      readings(at_column(73, "      S(J)=S(J)", "+0.1d0*props(1)") + "      A=1\n" + at_column(72, "      B=2", "+3"));
  EXPECT_EQ(numbers(found.tails), "1 +0.1d0*props(1)|3 3|");
  EXPECT_TRUE(found.cards.empty());
  EXPECT_TRUE(found.cut.empty());
  const auto sentences = column_sentences(found, "m.f");
  ASSERT_EQ(sentences.size(), 1u);
  EXPECT_EQ(sentences[0],
            "m.f:1: code beyond column 72 (2 lines: 1, 3), here '+0.1d0*props(1)': Abaqus reads it, since it takes 132 "
            "columns, and so does assay; a compiler at its usual 72 columns drops it silently");
}

TEST(FortranColumns, CommentsAndBlanksRaiseNoAlarm) {
  const std::string text =
      at_column(80, "C     a comment", "that is long") + at_column(80, "      A=1 ! short", "and a long comment") +
      at_column(90, "      A='!'", "! don't") + at_column(100, "      A=2", "  ") +
      at_column(73, "      A=3", "! a comment there") + at_column(90, "*", "*") + at_column(90, "!", "x") +
      at_column(90, "d     X=1", "+1") + at_column(90, "#if A", "B") + "     1 +2\n" + std::string(140, ' ') + "\n";
  const ColumnReadings found = readings(text);
  EXPECT_EQ(numbers(found.tails) + numbers(found.cards) + numbers(found.cut), "");
}

TEST(FortranColumns, AQuoteDecidesWhatIsAComment) {
  EXPECT_EQ(numbers(readings(at_column(60, "      A='x", "! y'") + at_column(75, "      B='", "! z'")).tails),
            "2 ! z'|");
  EXPECT_EQ(numbers(readings("      A='x\n" + at_column(70, "     1 y", "! still text'")).tails), "2 till text'|");
}

TEST(FortranColumns, TabsAreWrittenOut) {
  EXPECT_EQ(numbers(readings("\tA=1" + std::string(63, ' ') + "+2\n").tails), "1 +2|") << "column 73 behind the tab";
  EXPECT_EQ(numbers(readings("\tA=1" + std::string(61, ' ') + "+2\n").tails), "") << "columns 71 and 72";
}

TEST(FortranColumns, NumbersOfCardsAreKnown) {
  const ColumnReadings found =
      readings(at_column(73, "      A = 1.d0", "00000010") + at_column(73, "C     comment", "00000020") +
               at_column(73, "      CALL B(A)", "00000030"));
  EXPECT_EQ(numbers(found.cards), "1 00000010|3 00000030|");
  EXPECT_TRUE(found.tails.empty());
  const auto sentences = column_sentences(found, "dir/m.f");
  ASSERT_EQ(sentences.size(), 1u);
  EXPECT_EQ(sentences[0],
            "dir/m.f:1: columns 73 to 80 hold the numbers of punched cards (2 lines: 1, 3), and Abaqus reads them as "
            "code, since it takes 132 columns: this line ends in '1.d000000010', here too; to remove them: "
            "cut -c1-72 m.f > m_72.f");
}

TEST(FortranColumns, CardsHaveLettersAndBeginAnewInARoutine) {
  std::string text;
  for (int routine = 0; routine < 2; ++routine) {
    for (int k = 1; k <= 6; ++k) text += at_column(73, "      A=1", "UMAT00" + std::to_string(k) + "0");
  }
  EXPECT_EQ(readings(text).cards.size(), 12u);
  EXPECT_EQ(readings(at_column(73, "      A=1", "00000010")).cards.size(), 1u)
      << "one is enough where it fills the card";
}

TEST(FortranColumns, OtherNumbersAreTails) {
  for (const char* tail : {"2", "+00000010", "000000100", "1234.5", "ABCDEFGH", "10 + B"}) {
    const ColumnReadings found = readings(at_column(73, "      A=", tail));
    EXPECT_EQ(found.cards.size(), 0u) << tail;
    EXPECT_EQ(found.tails.size(), 1u) << tail;
  }
  const std::string falling = at_column(73, "      A=", "00000030") + at_column(73, "      A=", "00000020");
  EXPECT_EQ(readings(falling).cards.size(), 0u) << "they do not rise";
  EXPECT_EQ(readings(at_column(72, "      A=", "100000010")).cards.size(), 0u) << "the number begins before the card's";
  const ColumnReadings mixed = readings(at_column(73, "      A=1", "00000010") + at_column(73, "      A=2", "+3") +
                                        at_column(73, "      A=1", "00000020"));
  EXPECT_EQ(numbers(mixed.cards) + numbers(mixed.tails), "1 00000010|3 00000020|2 +3|");
}

TEST(FortranColumns, BeyondColumn132NothingIsRead) {
  const ColumnReadings found = readings(at_column(133, "      A=1", "+2"));
  EXPECT_EQ(numbers(found.cut), "1 +2|");
  EXPECT_TRUE(found.tails.empty()) << "there is nothing in columns 73 to 132";
  EXPECT_EQ(column_sentences(found, "m.f").at(0),
            "m.f:1: code beyond column 132 (line 1), here '+2': Abaqus reads 132 columns and cuts this off silently, "
            "and so does assay");
  EXPECT_TRUE(readings(at_column(132, "      A=1", "2")).cut.empty());
}

/// "1, 3" of "(2 lines: 1, 3)", and of "(line 1)".
std::string told_lines(const std::string& text, const std::string& words) {
  std::string flat = text;  // CMake breaks its messages
  flat = std::regex_replace(flat, std::regex("\\s+"), " ");
  std::smatch found;
  const std::regex pattern(words + "[^(]*\\((?:line |[0-9]+ lines: )([^)]*)\\)");
  return std::regex_search(flat, found, pattern) ? found[1].str() : "";
}

// The build of a project with assay_add_foreign_material warns of the same lines.
TEST(FortranColumns, CMakeTellsTheSame) {
  if (tool_in_path("cmake").empty()) GTEST_SKIP() << "no cmake";
  const ScratchFolder scratch;
  const std::string text = at_column(73, "      A=1", "+2") + at_column(80, "C     long", "comment") +
                           at_column(75, "      B='it''s' ! [a; b", "c") +
                           at_column(90, "      C=\"!;\"", "//'x' ! y") + at_column(73, "      D=1", "00000010") +
                           at_column(73, "      E=1", "00000020") + "\tF=1" + std::string(63, ' ') + "+2\n" +
                           at_column(73, "      CALL A(X,", "&") + "     &  Y)\n";
  const std::string file = scratch.write("m.f", text);
  const ToolEnd ran =
      run_tool({.program = tool_in_path("cmake"),
                .arguments = {"-D", "SOURCE=" + file, "-P", tree_folder() + "/cmake/check_columns.cmake"}});
  std::string own;
  const std::vector<std::string> lines = lines_of_source(text);
  const std::vector<FortranForm> forms(lines.size(), FortranForm::fixed);
  for (const std::string& sentence :
       column_sentences(readings_of(adapted_lines(lines, forms), FortranForm::fixed), file)) {
    own += sentence + "\n";
  }
  for (const std::string words : {"code beyond column 72", "punched cards"}) {
    EXPECT_EQ(told_lines(ran.said, words), told_lines(own, words)) << ran.said << own;
    EXPECT_NE(told_lines(own, words), "") << own;
  }
}

TEST(FortranColumns, FreeFormHasNoColumns) {
  const ColumnReadings found = readings(at_column(90, "a = 1", "+ 2"), FortranForm::free);
  EXPECT_TRUE(found.tails.empty() && found.cards.empty() && found.cut.empty());
}

TEST(FortranColumns, ACommentThatTakesTheNextLineWithItIsTold) {
  const std::vector<std::string> lines{"C     files lie in C:\\temp\\",
                                       "      A=1.D0",
                                       "      B=2.D0 ! and there, too \\  ",
                                       "      C='\\'",
                                       "#define HARD 1 \\",
                                       "      D=1.D0",
                                       "! the last\\"};
  const auto sentences = joined_line_sentences(lines, FortranForm::fixed, "m.F");
  ASSERT_EQ(sentences.size(), 2u);
  EXPECT_TRUE(sentences[0].starts_with("m.F:1: the comment ends in a backslash")) << sentences[0];
  EXPECT_TRUE(sentences[1].starts_with("m.F:3: ")) << sentences[1];
  EXPECT_TRUE(joined_line_sentences({"      A=1.D0", "! none"}, FortranForm::free, "m.F90").empty());
}

}  // namespace
}  // namespace assay::drivers::test_fortran_columns
