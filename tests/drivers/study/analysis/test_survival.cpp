// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/analysis/recommendation.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "drivers/study/pages/study_pages.hpp"
#include "drivers/study/pages/words.hpp"
#include "drivers/system/input_error.hpp"
#include "tests/drivers/study/two_methods.hpp"

namespace assay::drivers::test_survival {
namespace {

std::vector<std::string> names_of(const std::vector<Survival>& found) {
  std::vector<std::string> names;
  for (const Survival& of : found) names.push_back(of.method);
  return names;
}

using Names = std::vector<std::string>;

TEST(Survival, CountsWhatBecameOfEachMethod) {
  const std::vector<Survival> found = survivals(two_method_study());
  EXPECT_EQ(names_of(found), (Names{"B2, AFLIP", "CPDI, FLIP", "uGIMP, FLIP", "Cheat"}));
  EXPECT_EQ(found[0].completed, 3) << "the case of the error budget does not count";
  EXPECT_EQ(found[0].error_ratio, 1) << "what uses the exact solution is no measure";
  EXPECT_NEAR(*found[1].error_ratio, 2e-2 / 9e-3, 1e-12) << "the median of 8/6, 20/9 and 50/9";
  EXPECT_EQ(found[2].died, 1);
  EXPECT_EQ(found[2].lost, std::vector<std::size_t>{6});
  EXPECT_FALSE(found[2].error_ratio);
  EXPECT_EQ(found[3].not_applicable, 1);
  EXPECT_EQ(found[3].asked(), 1);
  EXPECT_TRUE(found[3].uses_exact_solution);
  StudyFindings once = two_method_study();
  once.cases[4].figures["uses_exact_solution"] = true;  // in one case of three
  EXPECT_EQ(names_of(survivals(once))[0], "B2, AFLIP");
}

TEST(Survival, RanksByShareDeathsAndWhatWasAsked) {
  StudyFindings study = two_method_study();
  study.cases[3].outcome = "refused";  // B2: 2 of 3, none died
  study.cases[0].outcome = "unstable";
  EXPECT_EQ(names_of(survivals(study))[0], "B2, AFLIP");
  study.cases[3].outcome = "n/a";  // 2 of 2, against 2 of 3
  EXPECT_EQ(names_of(survivals(study))[0], "B2, AFLIP");
  study.cases[0].outcome = "completed";  // 3 of 3 were asked for more than 2 of 2
  EXPECT_EQ(names_of(survivals(study))[0], "CPDI, FLIP");
  study.cases[0].outcome = study.cases[1].outcome = study.cases[2].outcome = "stopped";
}

TEST(Survival, WhoWasStoppedOrNotRunHasNotDied) {
  StudyFindings study = two_method_study();
  EXPECT_EQ(unfinished_note(survivals(study)), "");
  study.cases[0].outcome = study.cases[1].outcome = "stopped";
  study.cases[2].outcome = "missing";
  const std::vector<Survival> found = survivals(study);
  for (const Survival& of : found) {
    const bool stopped = of.method == "CPDI, FLIP";
    EXPECT_EQ(of.unfinished, stopped ? 3 : 0) << of.method;
    EXPECT_EQ(of.died, of.method == "uGIMP, FLIP" ? 1 : 0) << of.method;
    if (stopped) {
      EXPECT_EQ(of.asked(), 3) << "they apply to it";
    }
  }
  const std::string note = "Stopped, or not run yet: CPDI, FLIP 3.";
  EXPECT_EQ(unfinished_note(found), note);
  const StoredStudy stored{"x", "x/study.json", study};
  EXPECT_NE(survival_text(stored, found).find(note), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(survival_json(stored, found))["methods"].back()["unfinished"].is_number(), true);
}

TEST(Survival, WithoutAnAxisOfMethodsThereIsNothingToRecommend) {
  StudyFindings study = two_method_study();
  study.axes = {"basis", "grid.spacing"};
  EXPECT_THROW(survivals(study), InputError);
}

TEST(Survival, TextNamesOneAndWhatItLoses) {
  StoredStudy study{"x", "x/study.json", two_method_study()};
  study.findings.cases[3].outcome = "unstable";
  study.findings.cases[3].reason = "det F is not positive";
  study.findings.cases[0].outcome = study.findings.cases[1].outcome = "refused";
  const std::string text = survival_text(study, survivals(study.findings));
  EXPECT_TRUE(
      text.starts_with("take B2, AFLIP: it completes 2 of the 3 cases that apply to it\n"
                       "  B2, AFLIP, grid.spacing=0.1: unstable, det F is not positive\n"))
      << text;
  EXPECT_NE(text.find("\nCPDI, FLIP                             1 of 3      0        2      0         5.6\n"),
            text.npos)
      << text;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80u) << line;
}

TEST(Survival, SettingsAreThoseOfTheStudysOwnText) {
  StoredStudy study{"x", "x/study.json", two_method_study()};
  const auto settings = [&] {
    return nlohmann::json::parse(survival_json(study, survivals(study.findings)))["settings"];
  };
  EXPECT_TRUE(settings().is_null());
  study.findings.study_yaml = "axes:\n  method:\n    'B2, AFLIP': {method: {basis: bspline2, terms: 4}}\n";
  EXPECT_EQ(settings(), "{method: {basis: bspline2, terms: 4}}");
  EXPECT_NE(
      survival_text(study, survivals(study.findings)).find("\n  its settings: {method: {basis: bspline2, terms: 4}}\n"),
      std::string::npos);
  study.findings.study_yaml = "axes: {method: [";
  EXPECT_TRUE(settings().is_null());
}

TEST(Survival, NobodyIsTakenWhereNoneCompletes) {
  StudyFindings none = two_method_study();
  for (std::size_t i = 0; i < 7; ++i) none.cases[i].outcome = "unstable";
  StudyFindings empty = two_method_study();
  empty.cases.clear();
  for (const StudyFindings& study : {empty, none}) {
    const StoredStudy stored{"x", "x/study.json", study};
    EXPECT_TRUE(survival_text(stored, survivals(study)).starts_with("no method can be recommended"));
    EXPECT_TRUE(nlohmann::json::parse(survival_json(stored, survivals(study)))["recommended"].is_null());
  }
}

}  // namespace
}  // namespace assay::drivers::test_survival
