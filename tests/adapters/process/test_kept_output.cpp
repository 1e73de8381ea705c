// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/process/fate.hpp"

#include <gtest/gtest.h>

namespace assay::adapters::test_kept_output {
namespace {

TEST(LastLine, IsTheLastThatSaysSomething) {
  EXPECT_EQ(last_line(""), "");
  EXPECT_EQ(last_line("\n \n"), "");
  EXPECT_EQ(last_line("first\nsecond"), "second");
  EXPECT_EQ(
      last_line("At line 7 of file m.f\nFortran runtime error: Missing initial left parenthesis in format\nF8.3)\n"
                "^\n\nError termination. Backtrace:\n#0  0x7f"),
      "Fortran runtime error: Missing initial left parenthesis in format");
  EXPECT_EQ(last_line("why\nPAUSE\nTo resume execution, type go.  Other input will terminate the job.\n"), "PAUSE");
  EXPECT_EQ(last_line("first\nsecond\r\n\n"), "second");
}

TEST(LastLine, HoldsNothingThatATerminalOrXmlWouldTakeForMore) {
  EXPECT_EQ(last_line("\033[31mred\033[0m \001"), "?[31mred?[0m");
  EXPECT_EQ(last_line("caf\xc3\xa9 \xff"), "caf?? ?");
  EXPECT_EQ(last_line(std::string(1000, 'x')).size(), 200u);
}

}  // namespace
}  // namespace assay::adapters::test_kept_output
