// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/findings/findings.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace assay::drivers::test_verdict {
namespace {

TEST(Verdict, ItsTimesStayWithinATerminal) {
  constexpr std::size_t columns = 80;
  Result result;
  result.setup_s = 0.0299, result.wall_s = 0.611, result.finish_s = 0.0004, result.observed_s = 0.554;
  const std::string text = times_text(result, "stepping");
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), columns) << line;
  EXPECT_EQ(text.substr(0, 24), "  0.641 s: set-up 0.0299");
  EXPECT_NE(text.find("errors, pictures and"), text.npos) << text;
}

}  // namespace
}  // namespace assay::drivers::test_verdict
