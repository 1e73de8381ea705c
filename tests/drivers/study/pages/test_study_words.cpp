// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/pages/words.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "drivers/study/pages/study_pages.hpp"
#include "drivers/study/pages/study_sections.hpp"
#include "tests/drivers/study/sample_study.hpp"

namespace assay::drivers::test_study_words {
namespace {

TEST(StudyWords, HistoriesAreOfTheFrontAndThenOfEverySeries) {
  const StudyFindings findings = sample_study();
  const std::vector<std::size_t> drawn = drawn_histories(findings);
  ASSERT_EQ(drawn.size(), 7U);
  EXPECT_EQ(std::set<std::size_t>(drawn.begin(), drawn.end()).size(), 7U) << "none twice";
  for (const std::size_t i : drawn) EXPECT_FALSE(findings.cases[i].history.empty());
}

TEST(StudyWords, OfFewCasesEveryHistoryIsDrawnTheUnstableToo) {
  StudyFindings findings = sample_study();
  findings.work_front.resize(1);
  findings.series.resize(2);
  const std::vector<std::size_t> drawn = drawn_histories(findings);
  EXPECT_EQ(drawn.front(), findings.work_front.front());
  for (const StudySeries& series : findings.series) {
    const std::size_t finest = series.cases.back();
    const bool known = std::find(drawn.begin(), drawn.end(), finest) != drawn.end();
    EXPECT_EQ(known, !findings.cases[finest].history.empty()) << series.name;
  }
}

std::vector<std::string> front_heads(const StudyFindings& findings) {
  std::vector<std::string> heads;
  for (const study_page::Column& column : study_page::front(findings).table.columns) {
    const std::string& head = column[study_page::Page::markdown];
    if (!head.empty()) heads.push_back(head);
  }
  return heads;
}

TEST(StudyWords, ParticleStepsAreOneColumn) {
  StudyFindings findings = sample_study();
  EXPECT_EQ(front_heads(findings).size(), 5U);
  findings.cost_key = work_key, findings.cost_name = "particle-steps";
  EXPECT_EQ(front_heads(findings), (std::vector<std::string>{"case", "resolution", "error", "particle-steps"}));
  EXPECT_EQ(study_markdown(findings).find("particle-steps | particle-steps"), std::string::npos);
}

}  // namespace
}  // namespace assay::drivers::test_study_words
