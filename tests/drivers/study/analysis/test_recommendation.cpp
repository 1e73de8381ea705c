// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/analysis/recommendation.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "drivers/study/pages/study_pages.hpp"
#include "drivers/system/input_error.hpp"
#include "tests/drivers/study/two_methods.hpp"

namespace assay::drivers::test_recommendation {
namespace {

using CaseIndex = std::optional<std::size_t>;

StoredStudy stored_sample() { return {"results/x y", "results/x y/study.json", two_method_study()}; }

TEST(Recommendation, TakesTheCheapestThatMeetsTheError) {
  const StudyFindings study = two_method_study();
  EXPECT_EQ(recommended(study, 0.1).best, CaseIndex(3));
  EXPECT_EQ(recommended(study, 1e-2).best, CaseIndex(4));
  EXPECT_EQ(recommended(study, 9e-3).best, CaseIndex(4)) << "at most";
  EXPECT_EQ(recommended(study, 8.9e-3).best, CaseIndex(5));
  EXPECT_FALSE(recommended(study, 1e-2).nearest);
}

TEST(Recommendation, NamesAnotherMethod) {
  const Recommendation found = recommended(two_method_study(), 1e-2);
  EXPECT_EQ(found.runner_up, CaseIndex(2)) << "not its own finer grid, which is cheaper";
  EXPECT_TRUE(found.told_apart);
  EXPECT_FALSE(recommended(two_method_study(), 1e-3).runner_up);
  StudyFindings alike = two_method_study();
  set_clock(alike.cases[2], {4.1, 4.0, 4.2});
  EXPECT_FALSE(recommended(alike, 1e-2).told_apart);
}

TEST(Recommendation, WithoutAnAxisOfMethodsSeriesAreMethods) {
  StudyFindings study = two_method_study();
  for (StudyCase& one : study.cases) one.values[0].axis = "basis";
  EXPECT_EQ(recommended(study, 1e-2).runner_up, CaseIndex(2));
}

TEST(Recommendation, NeverTakesWhatUsesTheExactSolution) {
  StudyFindings study = two_method_study();
  EXPECT_FALSE(recommended(study, 1e-4).best);
  study.cases[7].eligible = true;  // though a file says so
  EXPECT_FALSE(recommended(study, 1e-4).best);
  study.cases[9].eligible = true;  // of the error budget
  EXPECT_FALSE(recommended(study, 1e-4).best);
  study.cases[6].eligible = true;  // unstable
  EXPECT_EQ(recommended(study, 1e-4).nearest, CaseIndex(5));
}

TEST(Recommendation, NamesTheBestFoundWhereNoneMeets) {
  const Recommendation found = recommended(two_method_study(), 1e-9);
  EXPECT_FALSE(found.best || found.runner_up || found.next);
  EXPECT_EQ(found.nearest, CaseIndex(5));
  EXPECT_FALSE(recommended({}, 1).nearest);
}

TEST(Recommendation, TellsTheNextDigit) {
  const auto next = recommended(two_method_study(), 1e-2).next;
  ASSERT_TRUE(next);
  EXPECT_EQ(next->error, 1e-3);
  EXPECT_EQ(next->best, CaseIndex(5));
  EXPECT_DOUBLE_EQ(*next->factor, 8);
  const auto beyond = recommended(two_method_study(), 2e-3).next;
  ASSERT_TRUE(beyond);
  EXPECT_EQ(beyond->error, 1e-4) << "its case reaches 1e-3 already";
  EXPECT_FALSE(beyond->best || beyond->factor);
  StudyFindings coarse = two_method_study();
  coarse.digits.resize(1);
  EXPECT_FALSE(recommended(coarse, 1e-2).next);
}

TEST(Recommendation, OfEqualCostTheMoreAccurate) {
  StudyFindings study = two_method_study();
  set_clock(study.cases[5], {4, 4, 4});
  EXPECT_EQ(recommended(study, 1e-2).best, CaseIndex(5));
}

TEST(Recommendation, ReadsTheWantedError) {
  StudyFindings study = two_method_study();
  EXPECT_EQ(wanted_error(study, "1e-3"), 1e-3);
  EXPECT_EQ(wanted_error(study, "1 %"), 0.01);
  EXPECT_EQ(wanted_error(study, "1%"), 0.01);
  for (const char* bad : {"", "x", "0", "-1", "%", " 1", ".inf", ".nan", "1 % %", "0x1", "1 m"})
    EXPECT_THROW(wanted_error(study, bad), InputError) << bad;
  study.error_unit = "m";
  EXPECT_EQ(wanted_error(study, "0.5"), 0.5);
  EXPECT_THROW(wanted_error(study, "1 %"), InputError);
}

TEST(Recommendation, TextSaysHowToRunIt) {
  const StoredStudy study = stored_sample();
  const std::string text = recommendation_text(study, recommended(study.findings, 1e-2));
  EXPECT_NE(text.find("take B2, AFLIP, grid.spacing=0.05\n"), text.npos) << text;
  EXPECT_NE(text.find("\n  assay run 'results/x y/cases/B05/case.yaml' --threads 2\n"), text.npos) << text;
  EXPECT_NE(text.find("error 0.9 %, cost 4 s (+- 1 %), 2 threads"), text.npos) << text;
  EXPECT_NE(text.find("8 times the"), text.npos) << text;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    EXPECT_TRUE(line.size() <= 80 || line.starts_with("  assay run ")) << line;
  }
}

TEST(Recommendation, TextSaysWhereNoneMeets) {
  const StoredStudy study = stored_sample();
  const std::string text = recommendation_text(study, recommended(study.findings, 1e-9));
  EXPECT_TRUE(text.starts_with("no measured case has")) << text;
  EXPECT_NE(text.find("the best found: B2, AFLIP, grid.spacing=0.025"), text.npos) << text;
  EXPECT_NE(recommendation_text({}, recommended({}, 1)).find("no case can be recommended"), text.npos);
}

TEST(Recommendation, JsonHasEveryKey) {
  const StoredStudy study = stored_sample();
  const auto met = nlohmann::json::parse(recommendation_json(study, recommended(study.findings, 1e-2)));
  EXPECT_EQ(met["recommended"]["label"], "B2, AFLIP, grid.spacing=0.05");
  EXPECT_EQ(met["recommended"]["folder"], "results/x y/cases/B05");
  EXPECT_EQ(met["recommended"]["cost"], 4.0);
  EXPECT_EQ(met["next_digit"]["best"]["number"], 6);
  EXPECT_TRUE(met["nearest"].is_null());
  const auto unmet = nlohmann::json::parse(recommendation_json(study, recommended(study.findings, 1e-9)));
  EXPECT_EQ(unmet.size(), met.size());
  EXPECT_EQ(unmet["met"], false);
  EXPECT_TRUE(unmet["recommended"].is_null());
  EXPECT_EQ(unmet["nearest"]["number"], 6);
}

}  // namespace
}  // namespace assay::drivers::test_recommendation
