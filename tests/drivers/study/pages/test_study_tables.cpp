// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/pages/study_pages.hpp"

#include <gtest/gtest.h>

#include "tests/drivers/study/sample_study.hpp"

namespace assay::drivers::test_study_tables {
namespace {

/// Records of a CSV text (RFC 4180).
std::vector<std::vector<std::string>> records_of(const std::string& text) {
  std::vector<std::vector<std::string>> records(1, {""});
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '"' && quoted && i + 1 < text.size() && text[i + 1] == '"') {
      records.back().back() += text[i++];
    } else if (text[i] == '"') {
      quoted = !quoted;
    } else if (!quoted && text[i] == ',') {
      records.back().emplace_back();
    } else if (!quoted && text[i] == '\n') {
      records.push_back({""});
    } else {
      records.back().back() += text[i];
    }
  }
  records.pop_back();
  return records;
}

TEST(StudyTables, every_file_is_rectangular_and_has_rows) {
  const auto tables = study_tables(sample_study());
  EXPECT_EQ(tables.size(), 10u);
  for (const auto& [name, text] : tables) {
    const auto records = records_of(text);
    EXPECT_GT(records.size(), 1u) << name;
    for (const auto& record : records) EXPECT_EQ(record.size(), records[0].size()) << name;
  }
}

TEST(StudyTables, cases_hold_axes_and_figures_of_error) {
  const auto records = records_of(study_tables(sample_study()).at("cases.csv"));
  const std::vector<std::string> head{
      "number", "key",   "method",       "grid.spacing",   "budget",         "outcome",       "reason",
      "t",      "error", "error.l2_max", "error.relative", "particle_steps", "material_calls"};
  EXPECT_EQ(records[0], head);
  EXPECT_EQ(records[1][2], "CPDI, FLIP");
  EXPECT_EQ(records[1][8], "0.3");
  EXPECT_NE(records[18][6].find("<&> \"far out\""), std::string::npos) << records[18][6];
  EXPECT_EQ(records[18][8], "");
}

TEST(StudyTables, clocks_are_not_in_the_deterministic_files) {
  const StudyFindings sample = sample_study();
  StudyFindings slower = sample;
  for (StudyCase& one : slower.cases) {
    if (one.cost) *one.cost *= 3;
    one.cost_spread = 0.4;
    one.clock = {false, {5}, {6}, {7}, {1.5}, "another machine"};
    for (const char* key : {"step_cpu_s", "peak_rss_bytes"}) one.figures[key] = 1e3;
    for (PassFigures& pass : one.passes) pass.seconds *= 2;
  }
  slower.front = {0};
  slower.machines = {"another machine"};
  const auto before = study_tables(sample), after = study_tables(slower);
  for (const char* file : {"cases.csv", "orders.csv", "histories.csv", "budget.csv", "stability.csv"}) {
    EXPECT_EQ(before.at(file), after.at(file)) << file;
  }
  for (const char* file : {"timing.csv", "work_precision.csv", "pareto.csv", "passes.csv"}) {
    EXPECT_NE(before.at(file), after.at(file)) << file;
  }
}

TEST(StudyTables, every_repeat_is_a_row) {
  const auto records = records_of(study_tables(sample_study()).at("timing.csv"));
  std::size_t rows = 1;
  for (const StudyCase& one : sample_study().cases) rows += one.clock.step_s.size();
  EXPECT_EQ(records.size(), rows);
}

TEST(StudyTables, nothing_completed_and_nothing_at_all) {
  EXPECT_EQ(records_of(study_tables(failed_study()).at("pareto.csv")).size(), 1u);
  for (const auto& [name, text] : study_tables({})) EXPECT_EQ(records_of(text).size(), 1u) << name;
}

}  // namespace
}  // namespace assay::drivers::test_study_tables
