// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/pages/study_pages.hpp"

#include <gtest/gtest.h>

#include <regex>
#include <sstream>

#include "tests/drivers/study/sample_study.hpp"
#include "tests/drivers/study/two_methods.hpp"

namespace assay::drivers::test_study_text {
namespace {

/// The longest line in characters, not bytes.
std::size_t longest_line(const std::string& text) {
  std::istringstream in(text);
  std::size_t longest = 0;
  for (std::string line; std::getline(in, line);) {
    const auto characters = std::count_if(line.begin(), line.end(),
                                          [](char c) { return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u; });
    longest = std::max(longest, static_cast<std::size_t>(characters));
  }
  return longest;
}

bool says(const std::string& text, const std::string& line) { return ("\n" + text).find("\n" + line) != text.npos; }

TEST(StudyText, NoLineIsLongerThanEightyColumns) {
  std::vector<StudyFindings> all{sample_study(), two_method_study(), failed_study(), crowded_study(12),
                                 StudyFindings()};
  all.push_back(sample_study());  // units, long costs, letters of two bytes
  all.back().error_unit = "m/s", all.back().cost_unit = "B";
  for (StudyCase& one : all.back().cases) {
    one.label = "\u00e9\u00e9\u00e9\u00e9 \u00e9\u00e9\u00e9\u00e9\u00e9\u00e9\u00e9\u00e9\u00e9 " + one.label + ", " +
                one.label + ", " + one.label;
    if (one.cost) *one.cost *= 12345678;
    if (one.error) *one.error *= 1.234e-7;
  }
  for (std::size_t length = 1; length < 120; ++length) {  // every length of a label, with and without blanks
    StudyFindings one = two_method_study();
    for (StudyCase& each : one.cases) {  // a word of a sentence is not cut: those that died keep theirs
      if (each.completed()) each.label = std::string(length, 'l');
    }
    for (StudySeries& series : one.series) {
      for (std::size_t i = 0; i < length; ++i) series.name += i % 4 == 3 ? ' ' : 's';
    }
    all.push_back(std::move(one));
  }
  for (const StudyFindings& findings : all) {
    EXPECT_LE(longest_line(study_text(findings, "results/quick")), 80u);
    for (const StudyCase& one : findings.cases) {
      EXPECT_LE(longest_line(case_line(findings, one, 3, 4000)), 80u) << case_line(findings, one, 3, 4000);
    }
  }
}

TEST(StudyText, WhatFitsIsNotCut) {
  StudyFindings findings = two_method_study();
  const std::string begin = "  1/10  completed  8 %       1 s       ";
  StudyCase one = findings.cases[0];
  one.label = std::string(80 - begin.size(), 'l');
  EXPECT_EQ(case_line(findings, one, 1, 10), begin.substr(1) + one.label + "\n");
  const std::string room(81 - begin.size(), 'l');
  one.label = room + "lll";
  EXPECT_EQ(case_line(findings, one, 1, 10),
            begin.substr(1) + room + "\n" + std::string(begin.size() - 1, ' ') + "lll\n");
}

TEST(StudyText, ACaseThatHasEndedIsOneLine) {
  const StudyFindings findings = two_method_study();
  EXPECT_EQ(case_line(findings, findings.cases[5], 6, 10),
            " 6/10  completed  0.09 %    32 s      B2, AFLIP, grid.spacing=0.025\n");
  EXPECT_EQ(case_line(findings, findings.cases[6], 7, 10),
            " 7/10  unstable                       uGIMP, FLIP, grid.spacing=0.1\n");
  StudyCase failed = findings.cases[6];
  failed.outcome = "material_failed";
  EXPECT_EQ(case_line(findings, failed, 10, 10),
            "10/10  material_failed                     uGIMP, FLIP, grid.spacing=0.1\n");
}

TEST(StudyText, TellsTheAnswerFirst) {
  const StudyFindings findings = two_method_study();
  const std::string text = study_text(findings, "results/two");
  const char* lines[] = {"Two methods: 8 completed, 1 unstable, 1 n/a: AS EXPECTED\n",
                         "  Which is cheaper?\n",
                         "  error: largest L2 error of u over the largest |u|; cost:",
                         "  error     costs     one more  the cheapest case that was measured\n",
                         "  <= 10 %   0.4 s               0.5 s: B2, AFLIP, grid.spacing=0.1\n",
                         "  <= 1 %    3.8 s     \u00d79.5      4 s: B2, AFLIP, grid.spacing=0.05\n",
                         "  <= 0.01 % -                   no case of this study\n",
                         "cases that no other case beats in both error and cost:\n",
                         "  6 %       0.5 s     +-1 %     B2, AFLIP, grid.spacing=0.1\n",
                         "orders, with 95 % intervals:\n",
                         "  2 [2, 2]            asymptotic      CPDI, FLIP\n",
                         "share of each source of error, found by refining it alone:\n",
                         "  10 %      0.9 %     0.8 %     time step (time.step=0.001), B2, AFLIP,",
                         "not completed:\n",
                         "  unstable: uGIMP, FLIP, grid.spacing=0.1: det F is not above 0\n",
                         "  warning: case 3 was disturbed\n",
                         "  1 of 1 expectations hold\n",
                         "AS EXPECTED; results in results/two, begin with its report.html\n"};
  std::size_t last = 0;
  for (const char* line : lines) {
    EXPECT_TRUE(says(text, line)) << line << "\nin\n" << text;
    const std::size_t at = ("\n" + text).find("\n" + std::string(line));
    EXPECT_GE(at, last) << line;
    last = at;
  }
}

TEST(StudyText, SaysWhatFailsAndWhatNobodyExpected) {
  StudyFindings findings = two_method_study();
  findings.expect.push_back({"CPDI, FLIP", {"order", "above 2.5", "2.00000001", false}});
  std::string text = study_text(findings, "r");
  EXPECT_TRUE(says(text, "  FAILS order above 2.5: found 2; CPDI, FLIP\n")) << text;
  EXPECT_TRUE(says(text, "  1 of 2 expectations hold\n"));
  EXPECT_TRUE(says(text, "NOT AS EXPECTED; results in r"));
  findings.expect.clear();
  text = study_text(findings, "r");
  EXPECT_TRUE(says(text, "NOTHING WAS EXPECTED; results in r"));
  EXPECT_EQ(text.find("expectations hold"), text.npos);
  findings.cases[0].outcome = "missing";
  EXPECT_TRUE(says(study_text(findings, "r"), "NOT AS EXPECTED; results in r")) << "a case is missing";
}

TEST(StudyText, FailuresComeBeforeTheAnswer) {
  StudyFindings findings = two_method_study();
  findings.expect.push_back({"CPDI, FLIP", {"order", "above 2.5", "2.00000001", false}});
  const std::string text = study_text(findings, "r");
  EXPECT_TRUE(text.starts_with("Two methods: 8 completed, 1 unstable, 1 n/a: NOT AS EXPECTED\n  FAILS order ")) << text;
  EXPECT_TRUE(text.starts_with(contradiction_text(findings)));
}

TEST(StudyText, LongLabelsGoOnBelowAndAreNotCut) {
  StudyFindings findings = two_method_study();
  const std::string label = "total B2, AFLIP, k=4, grid.spacing=0.0234375, body.lattice=jittered, method.courant=0.2";
  for (StudyCase& one : findings.cases) one.label = label;
  std::string joined, line;
  for (std::istringstream page(study_text(findings, "r") + case_line(findings, findings.cases[0], 1, 10));
       std::getline(page, line);) {
    EXPECT_LE(line.size(), 81u) << line;  // a multiplication sign has two bytes
    joined += " " + line;
  }
  joined = std::regex_replace(joined, std::regex(" +"), " ");
  std::size_t count = 0;
  for (std::size_t at = 0; (at = joined.find(label, at)) != joined.npos; ++at) ++count;
  EXPECT_GE(count, findings.front.size() + 3) << joined;
  EXPECT_EQ(joined.find("..."), joined.npos);
}

TEST(StudyText, PublishedOrdersStandBelowOurs) {
  StudyFindings findings = two_method_study();
  findings.series[0].published = 0.8, findings.series[0].source = "Brannon et al., figure 4";
  EXPECT_TRUE(
      says(study_text(findings, "r"),
           "  2 [2, 2]            asymptotic      CPDI, FLIP\n    published: 0.8 (Brannon et al., figure 4)\n"));
}

TEST(StudyText, AStudyWithoutAnythingSaysSo) {
  EXPECT_EQ(study_text(StudyFindings(), "r"),
            "study: NOTHING WAS EXPECTED\n  error: ; cost:\nno case has both an error and a cost\n"
            "NOTHING WAS EXPECTED; results in r, begin with its report.html\n");
  const std::string failed = study_text(failed_study(), "r");
  EXPECT_TRUE(says(failed, "no case has both an error and a cost\n"));
  EXPECT_FALSE(says(failed, "cases that no other case beats"));
  EXPECT_FALSE(says(failed, "orders"));
  StudyFindings still = two_method_study();
  still.digits.clear(), still.front.clear();
  for (StudyCase& one : still.cases) one.error.reset(), one.figures["error.l2_max"] = 0.0;
  EXPECT_TRUE(says(study_text(still, "r"),
                   "no case has both an error and a cost: the exact displacement is zero in 8 cases,\n"
                   "  and a relative error is undefined there; error: error.l2_max is one in metres\n"))
      << study_text(still, "r");
  StudyFindings zero = two_method_study();
  zero.digits.clear();
  EXPECT_TRUE(says(study_text(zero, "r"), "the error is 0, so there is no next digit\n"));
}

}  // namespace
}  // namespace assay::drivers::test_study_text
