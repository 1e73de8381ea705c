// SPDX-License-Identifier: BSD-3-Clause
// docs/architecture.md: what to read first is as short as the page says.
#include <gtest/gtest.h>

#include <cmath>
#include <regex>
#include <string>

#include "tests/house/tree.hpp"

namespace assay::test_architecture {
namespace {

constexpr double drift = 0.05;  ///< of a number of lines, before the page must follow
constexpr int longest = 4000;   ///< lines that can be read in an hour or two

/// The lines of all files that a row of the table names.
int lines_of_files(const std::string& row) {
  static const std::regex file("`([^`]+)`");
  int lines = 0;
  for (std::sregex_iterator at(row.begin(), row.end(), file), end; at != end; ++at)
    lines += static_cast<int>(house::lines_of(house::text_of((*at)[1])).size());
  return lines;
}

TEST(Architecture, WhatToReadFirstIsAsShortAsThePageSays) {
  static const std::regex row(R"(\| [^|]+ \| (`[^|]+`) \| (\d+) \|)");
  const std::string page = house::text_of("docs/architecture.md");
  const std::size_t begin = page.find("## What to read first");
  ASSERT_NE(begin, page.npos);
  int rows = 0, whole = 0;
  for (const std::string& line : house::lines_of(page.substr(begin, page.find("\n## ", begin) - begin))) {
    std::smatch found;
    if (!std::regex_match(line, found, row)) continue;
    const int lines = lines_of_files(found[1]);
    EXPECT_NEAR(std::stoi(found[2]), lines, drift * lines) << line;
    whole += lines;
    ++rows;
  }
  EXPECT_EQ(rows, 10);
  EXPECT_LT(whole, longest);
}

}  // namespace
}  // namespace assay::test_architecture
