// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/analysis/findings.hpp"

#include <gtest/gtest.h>

#include "tests/drivers/study/study_text_fixture.hpp"
#include "tests/drivers/study/two_methods.hpp"

namespace assay::drivers::test_study_expect {
namespace {

/// A study whose axes are those of two_method_study(), with `expect` in flow style.
Study study_expecting(const std::string& expect) {
  return StudyFolder().read(
      "axes:\n"
      "  method: {'CPDI, FLIP': {}, 'B2, AFLIP': {}, 'uGIMP, FLIP': {}, Cheat: {}, None: {}}\n"
      "  grid.spacing: [0.1, 0.05, 0.025]\n"
      "expect: " +
      expect + "\n");
}

/// "key expected: found, holds or fails; where", one line each.
std::vector<std::string> judged_lines(const std::string& expect, const StudyFindings& findings = two_method_study()) {
  std::vector<std::string> lines;
  for (const auto& [where, outcome] : judged_of(study_expecting(expect), findings)) {
    lines.push_back(outcome.key + " " + outcome.expected + ": " + outcome.found +
                    (outcome.holds ? ", holds" : ", fails") + "; " + where);
  }
  return lines;
}

using Lines = std::vector<std::string>;

TEST(StudyExpect, IsJudgedOfEveryCaseOfItsSelection) {
  EXPECT_EQ(
      judged_lines("[{where: {method: 'CPDI, FLIP', grid.spacing: {above: 0.03}}, error.relative: {below: 0.05}}]"),
      (Lines{"error.relative below 0.05: 0.08, fails; CPDI, FLIP, grid.spacing=0.1",
             "error.relative below 0.05: 0.02, holds; CPDI, FLIP, grid.spacing=0.05"}));
  EXPECT_EQ(judged_lines("[{where: {method: Cheat}, error.relative: 1e-5}]"),
            (Lines{"error.relative equals 1e-05: 1e-05, holds; Cheat, grid.spacing=0.1",
                   "error.relative equals 1e-05: null, fails; Cheat, grid.spacing=0.05",
                   "outcome completed: n/a, fails; Cheat, grid.spacing=0.05"}));
}

TEST(StudyExpect, TrueAndFalseAreValues) {
  StudyFindings findings = two_method_study();
  findings.cases[0].figures["uses_exact_solution"] = false;
  EXPECT_EQ(judged_lines("[{where: {method: 'CPDI, FLIP', grid.spacing: 0.1}, uses_exact_solution: false}]", findings),
            Lines{"uses_exact_solution false: false, holds; CPDI, FLIP, grid.spacing=0.1"});
}

TEST(StudyExpect, ThatACaseCompletesIsToldOnce) {
  const std::string where = "where: {method: Cheat, grid.spacing: 0.05}", told = "; Cheat, grid.spacing=0.05";
  const std::string figure = "error.relative equals 1e-05: null, fails" + told;
  const std::string outcome = "outcome completed: n/a, fails" + told;
  const std::string line = "{" + where + ", error.relative: 1e-5}";
  EXPECT_EQ(judged_lines("[{" + where + ", outcome: completed}, " + line + "]"), (Lines{outcome, figure}));
  EXPECT_EQ(judged_lines("[" + line + ", {" + where + ", outcome: completed}]"), (Lines{figure, outcome}));
  EXPECT_EQ(judged_lines("[" + line + ", " + line + "]"), (Lines{figure, outcome, figure}));
  // An author who expects another outcome has not said that the figures are those of a case that completed.
  EXPECT_EQ(judged_lines("[{" + where + ", outcome: n/a}, " + line + "]"),
            (Lines{"outcome n/a: n/a, holds" + told, figure, outcome}));
}

TEST(StudyExpect, ThoseOfTheBudgetAreNotMeant) {
  EXPECT_EQ(judged_lines("[{where: {method: 'B2, AFLIP', grid.spacing: 0.05}, error.relative: {above: 1e-3}}]"),
            Lines{"error.relative above 0.001: 0.009, holds; B2, AFLIP, grid.spacing=0.05"});
}

TEST(StudyExpect, OutcomesAndReasonsAreTexts) {
  EXPECT_EQ(judged_lines("[{where: {method: 'uGIMP, FLIP'}, outcome: unstable, reason: det F is not above 0}]"),
            (Lines{"outcome unstable: unstable, holds; uGIMP, FLIP, grid.spacing=0.1",
                   "reason det F is not above 0: det F is not above 0, holds; uGIMP, FLIP, grid.spacing=0.1"}));
  EXPECT_EQ(judged_lines("[{where: {method: Cheat, grid.spacing: 0.05}, outcome: completed}]"),
            Lines{"outcome completed: n/a, fails; Cheat, grid.spacing=0.05"});
}

TEST(StudyExpect, AFigureThatWasNotReachedHoldsNothing) {
  EXPECT_EQ(judged_lines("[{where: {method: 'uGIMP, FLIP'}, error.relative: {above: -1}}]"),
            (Lines{"error.relative above -1: null, fails; uGIMP, FLIP, grid.spacing=0.1",
                   "outcome completed: unstable, fails; uGIMP, FLIP, grid.spacing=0.1"}));
}

TEST(StudyExpect, ARunThatHasDiedHoldsNothingUnlessThatIsExpected) {
  StudyFindings findings = two_method_study();
  findings.cases[6].figures["error.relative"] = 1e-3;  // the largest up to its end
  const std::string of_ugimp = "where: {method: 'uGIMP, FLIP'}, error.relative: {below: 0.1}";
  EXPECT_EQ(judged_lines("[{" + of_ugimp + "}]", findings),
            (Lines{"error.relative below 0.1: 0.001, holds; uGIMP, FLIP, grid.spacing=0.1",
                   "outcome completed: unstable, fails; uGIMP, FLIP, grid.spacing=0.1"}));
  EXPECT_EQ(judged_lines("[{" + of_ugimp + ", outcome: unstable}]", findings),
            (Lines{"error.relative below 0.1: 0.001, holds; uGIMP, FLIP, grid.spacing=0.1",
                   "outcome unstable: unstable, holds; uGIMP, FLIP, grid.spacing=0.1"}));
}

TEST(StudyExpect, ASelectionWithoutCasesHoldsNothing) {
  EXPECT_EQ(judged_lines("[{where: {method: None}, outcome: completed, order: {above: -100}, order_last: 1}]"),
            (Lines{"outcome completed: null, fails; no case", "order above -100: null, fails; no case",
                   "order_last equals 1: null, fails; no case"}));
  EXPECT_EQ(judged_lines("[{t: {above: -1}}]", StudyFindings()), Lines{"t above -1: null, fails; no case"});
}

TEST(StudyExpect, OrdersAreOfSeriesThatHaveACaseThere) {
  EXPECT_EQ(judged_lines("[{order: {above: 1.9}, order_last: {above: 3}}]"),
            (Lines{"order above 1.9: 2, holds; CPDI, FLIP", "order above 1.9: null, fails; B2, AFLIP",
                   "order_last above 3: 2, fails; CPDI, FLIP", "order_last above 3: 3.3, holds; B2, AFLIP"}));
  EXPECT_EQ(judged_lines("[{where: {method: {not: 'CPDI, FLIP'}, grid.spacing: 0.1}, order_last: {between: [3, 4]}}]"),
            Lines{"order_last between 3 and 4: 3.3, holds; B2, AFLIP"});
}

TEST(StudyExpect, TheLastOrderIsOfTheFinestThatCanBe) {
  StudyFindings findings = two_method_study();
  findings.cases[8].resolution.reset();  // n/a: it was never read
  findings.series[0].cases.push_back(8), findings.series[0].pairwise.push_back(std::nullopt);
  const std::string of_cpdi = "[{where: {method: 'CPDI, FLIP'}, order_last: {above: 1.9}}]";
  EXPECT_EQ(judged_lines(of_cpdi, findings), Lines{"order_last above 1.9: 2, holds; CPDI, FLIP"});
  findings.cases[8].resolution = 0.01;  // it died
  EXPECT_EQ(judged_lines(of_cpdi, findings), Lines{"order_last above 1.9: null, fails; CPDI, FLIP"});
  findings.series[0].cases.clear(), findings.series[0].pairwise.clear();
  EXPECT_EQ(judged_lines(of_cpdi, findings), Lines{"order_last above 1.9: null, fails; no case"});
}

}  // namespace
}  // namespace assay::drivers::test_study_expect
