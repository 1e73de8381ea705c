// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/process/fate.hpp"

#include <gtest/gtest.h>

namespace assay::adapters::test_missing_file {
namespace {

const std::string calls = "\n\nError termination. Backtrace:\n#0  0x7f in ???\n";

TEST(MissingFile, IsNamedFromWhatFortranPrints) {
  EXPECT_EQ(
      missing_file_words("At line 5 of file m.f (unit = 15)\nFortran runtime error: Cannot open file 'p.dat': No such "
                         "file or directory" +
                         calls),
      "; it looks for 'p.dat' in its own working folder: files: [p.dat] in its description copies "
      "a file there");
  EXPECT_NE(missing_file_words("Fortran runtime error: File 'dir/p.dat' does not exist").find("files: [dir/p.dat]"),
            std::string::npos);
  EXPECT_NE(missing_file_words(
                "At line 6 of file ./c.f (unit = 15, file = 'fort.15')\nFortran runtime error: End of file" + calls)
                .find("finds nothing to read in 'fort.15'"),
            std::string::npos);
}

TEST(MissingFile, IsNamedFromWhatOthersPrint) {
  EXPECT_NE(missing_file_words("PAUSE x\nTo resume execution, type go.  Other input will terminate the job.\n")
                .find("PAUSE waits for standard input"),
            std::string::npos);
  EXPECT_NE(missing_file_words("table.csv: No such file or directory\n").find("files: [table.csv]"), std::string::npos);
  EXPECT_NE(missing_file_words("fopen: No such file or directory\n").find("`files` in its description"),
            std::string::npos);
}

// What `files` cannot put there is not advised.
TEST(MissingFile, ThatNoFolderCanHoldIsNamedAlone) {
  for (const char* words : {"Fortran runtime error: Cannot open file '/no/such/t.dat': No such file or directory",
                            "/no/such/t.csv: No such file or directory\n",
                            "At line 6 of file c.f (unit = 5, file = 'stdin')\nFortran runtime error: End of file"}) {
    EXPECT_NE(missing_file_words(words), "") << words;
    EXPECT_EQ(missing_file_words(words).find("files:"), std::string::npos) << missing_file_words(words);
  }
}

TEST(MissingFile, OtherWordsAreNoFiles) {
  for (const char* words : {"", "converged", "Cannot open the valve", "File 'x' is read", "End of file",
                            "Fortran runtime error: Index '7' out of bounds"}) {
    EXPECT_EQ(missing_file_words(words), "") << words;
  }
}

TEST(MissingFile, TheReasonIsTheLastLine) {
  EXPECT_EQ(last_line("Fortran runtime error: End of file" + calls), "Fortran runtime error: End of file");
}

}  // namespace
}  // namespace assay::adapters::test_missing_file
