// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/pages/study_pages.hpp"

#include <gtest/gtest.h>

#include "tests/drivers/study/sample_study.hpp"
#include "tests/drivers/study/two_methods.hpp"

namespace assay::drivers::test_study_report {
namespace {

std::size_t place_in(const std::string& page, const std::string& text) {
  const std::size_t at = page.find(text);
  EXPECT_NE(at, std::string::npos) << text;
  return at;
}

TEST(StudyReport, question_and_answer_come_first) {
  const std::string page = study_report_html(sample_study(), {{"best <case>", "PNG"}});
  std::size_t last = 0;
  for (const char* text : {"<h1>What accuracy costs in the vortex &lt;of the paper&gt; &amp; its ring</h1>",
                           "Which method, on which grid",
                           "For 1 %",
                           "0.51 s",
                           "\u00d730",
                           "does not hold",
                           "<h2>What accuracy costs",
                           "<h2>The cases on the front",
                           "<h2>What the next digit costs",
                           "<h2>Errors over time",
                           "<h2>Orders of convergence",
                           "<h2>Particles",
                           "<h2>What completes and what does not",
                           "<h2>Where the error comes from",
                           "<h2>Where its time went",
                           "<h2>Expectations",
                           "<h2>Cases that did not complete",
                           "<h2>Warnings",
                           "<h2>The same in particle-steps",
                           "<h2>The clock",
                           "<h2>Origin of the results",
                           "<h2>The study",
                           "base: vortex.yaml"}) {
    const std::size_t at = place_in(page, text);
    EXPECT_GT(at, last) << text;
    last = at;
  }
}

TEST(StudyReport, of_survival_begins_with_the_methods_that_live) {
  StudyFindings findings = two_method_study();
  findings.asks_survival = true;
  const std::string page = study_report_html(findings, {});
  std::size_t last = 0;
  for (const char* text :
       {"Which is cheaper?", "<b>3 of 3</b>", "B2, AFLIP", "<h2>Which method completes the most cases", "<h2>The map",
        "<svg", "<h2>What completes and what does not", "<h2>Expectations", "<h2>Origin of the results"}) {
    const std::size_t at = place_in(page, text);
    EXPECT_GT(at, last) << text;
    last = at;
  }
  EXPECT_EQ(page.find("What accuracy costs"), std::string::npos);
  EXPECT_EQ(page.find("next digit"), std::string::npos);
}

TEST(StudyReport, stands_alone) {
  const std::string page = study_report_html(sample_study(), {{"best <case>", "PNG"}});
  for (const char* alien : {"<script", "src=\"http", "href=\"http", "@import", "url("}) {
    EXPECT_EQ(page.find(alien), std::string::npos) << alien;
  }
  place_in(page, "data:image/png;base64,UE5H");
  place_in(page, "best &lt;case&gt;");
  EXPECT_EQ(page.find("<&>"), std::string::npos);
  EXPECT_EQ(page.find("# <two>"), std::string::npos);
}

TEST(StudyReport, links_the_data_of_each_figure) {
  const std::string page = study_report_html(sample_study(), {});
  for (const auto& [name, text] : study_tables(sample_study())) place_in(page, "<a href=\"" + name + "\">");
}

TEST(StudyReport, a_busy_machine_is_remarked) {
  const std::string page = study_report_html(sample_study(), {});
  place_in(page, "the machine was busy with other things");
}

TEST(StudyReport, nothing_completed) {
  const std::string page = study_report_html(failed_study(), {});
  place_in(page, "No answer");
  place_in(page, ">no case completed</text>");
  place_in(page, "Cases that did not complete");
  EXPECT_EQ(page.find("The cases on the front"), std::string::npos);
  EXPECT_EQ(page.find("Errors over time"), std::string::npos);
  place_in(study_report_html({}, {}), "<h1>assay study</h1>");
}

TEST(StudyReport, no_digit_beyond_the_first_that_is_missed) {
  StudyFindings findings = sample_study();
  findings.digits.push_back({1e-5, {}, {}, "", {}, {}});
  EXPECT_EQ(study_report_html(findings, {}).find("For 0.001 %"), std::string::npos);
}

}  // namespace
}  // namespace assay::drivers::test_study_report
