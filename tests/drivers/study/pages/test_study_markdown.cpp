// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/pages/study_pages.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "tests/drivers/study/sample_study.hpp"
#include "tests/drivers/study/two_methods.hpp"

namespace assay::drivers::test_study_markdown {
namespace {

/// Cells of a line: bars that no backslash stands before, less one.
std::ptrdiff_t cells_of(const std::string& line) {
  std::ptrdiff_t bars = 0;
  for (std::size_t i = 0; i < line.size(); ++i) bars += line[i] == '|' && (i == 0 || line[i - 1] != '\\') ? 1 : 0;
  return bars - 1;
}

TEST(StudyMarkdown, tables_are_whole) {
  StudyFindings findings = sample_study();
  findings.cases[0].label = "a | bar";
  findings.cases[0].outcome = "refused";
  findings.cases[0].reason = "two\nlines | and <tags>";
  std::istringstream text(study_markdown(findings));
  std::ptrdiff_t width = 0;
  int tables = 0;
  for (std::string line; std::getline(text, line);) {
    if (!line.starts_with("|")) {
      width = 0;
      continue;
    }
    if (width == 0) width = cells_of(line), ++tables;
    EXPECT_EQ(cells_of(line), width) << line;
  }
  EXPECT_EQ(tables, 7);
}

TEST(StudyMarkdown, answers) {
  const std::string text = study_markdown(sample_study());
  for (const char* part :
       {"# What accuracy costs in the vortex \\<of the paper\\>", "Which method, on which grid",
        "| **1 %** | total Lagrangian B2, AFLIP | h = 0.025 | 0.51 s | 0.37 s | \u00d77 |", "unstable, t = 0.62 s",
        "**does not hold**", "not reached: orders", "- CPDI, FLIP, grid.spacing=0.025: other"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  }
}

TEST(StudyMarkdown, of_survival_names_methods_in_place_of_costs) {
  StudyFindings findings = two_method_study();
  findings.asks_survival = true;
  const std::string text = study_markdown(findings);
  EXPECT_NE(text.find("## Which method completes the most cases\n"), std::string::npos) << text;
  EXPECT_NE(text.find("| B2, AFLIP | 3 of 3 | 0 | 0 | 0 | 1 |\n"), std::string::npos) << text;
  EXPECT_NE(text.find("## What completes and what does not\n"), std::string::npos);
  EXPECT_EQ(text.find("next digit"), std::string::npos);
  EXPECT_EQ(text.find("front"), std::string::npos);
}

TEST(StudyMarkdown, of_nothing) { EXPECT_NE(study_markdown({}).find("# assay study"), std::string::npos); }

}  // namespace
}  // namespace assay::drivers::test_study_markdown
