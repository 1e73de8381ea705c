// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/analysis/findings.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace assay::drivers::test_budget {
namespace {

using History = std::vector<std::array<double, 2>>;

TEST(Budget, TheLargestChangeIsThatOfTheClosedForm) {
  // base t, other t + t (1 - t) / 2: they differ by t (1 - t) / 2, at most 1/8 at t = 1/2; the largest value is 1
  History base, same_times, other_times;
  for (int i = 0; i <= 10; ++i) {
    const double t = i / 10.0;
    base.push_back({t, t});
    same_times.push_back({t, t + 0.5 * t * (1 - t)});
  }
  EXPECT_NEAR(largest_change(base, same_times).value(), 0.125, 1e-15);
  EXPECT_EQ(largest_change(base, base), 0);
  for (int i = 0; i <= 1000; ++i) {
    const double t = i / 1000.0;
    other_times.push_back({t, t + 0.5 * t * (1 - t)});
  }
  EXPECT_NEAR(largest_change(base, other_times).value(), 0.125, 1e-12);
  for (auto& sample : base) sample[1] *= -4;
  for (auto& sample : same_times) sample[1] *= -4;
  EXPECT_NEAR(largest_change(base, same_times).value(), 0.125, 1e-15) << "over the largest, whatever its sign";
}

TEST(Budget, BetweenItsSamplesTheOtherIsALine) {
  EXPECT_DOUBLE_EQ(largest_change({{0, 0}, {0.25, 4}, {1, 0}}, {{0, 0}, {1, 2}}).value(), 3.5 / 4);
  EXPECT_DOUBLE_EQ(largest_change({{0.25, 4}}, {{0, 0}, {1, 2}}).value(), 3.5 / 4);
}

TEST(Budget, OnlyTimesThatBothHaveAreCompared) {
  EXPECT_DOUBLE_EQ(largest_change({{0, 1}, {1, 1}, {2, 100}}, {{0, 1}, {1, 51}}).value(), 0.5)
      << "over the largest of the run";
  EXPECT_DOUBLE_EQ(largest_change({{0, 1}, {1, 1}}, {{0.5, 5}, {1, 3}}).value(), 2);
  EXPECT_FALSE(largest_change({{0, 1}}, {{1, 2}, {2, 2}}));
  EXPECT_FALSE(largest_change({{3, 1}}, {{1, 2}, {2, 2}}));
  EXPECT_FALSE(largest_change({}, {{1, 2}}));
  EXPECT_FALSE(largest_change({{1, 2}}, {}));
  EXPECT_FALSE(largest_change({{0, 0}, {1, 0}}, {{0, 1}, {1, 1}})) << "there is no error to divide";
}

Setting setting_of(const std::string& path, const std::string& yaml) { return {path, read_yaml(yaml, "f"), {}}; }

/// Two cases, and of the first two that refine it.
Plan plan_of_two() {
  Plan plan;
  plan.study.budget = StudyBudget{{},
                                  {{"space", {setting_of("grid.spacing", "0.5")}},
                                   {"time", {setting_of("time.step", "1e-3"), setting_of("body.per_cell", "[2, 2]")}}}};
  plan.cases.resize(4);
  plan.cases[2].base = 0, plan.cases[2].source = 1;
  plan.cases[3].base = 0, plan.cases[3].source = 0;
  return plan;
}

std::vector<StudyCase> cases_of_two() {
  std::vector<StudyCase> cases(4);
  for (StudyCase& one : cases) one.outcome = "completed", one.history = {{0, 0}, {1, 2}};
  cases[0].label = "a", cases[0].error = 0.2;
  cases[2].error = 0.1, cases[2].history = {{0, 0}, {1, 1}};
  return cases;
}

TEST(Budget, HasALineForEachRefinedCase) {
  const auto lines = budget_of(plan_of_two(), cases_of_two());
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].base, "a");
  EXPECT_EQ(lines[0].source, "time");
  EXPECT_EQ(lines[0].changed, "time.step=1e-3, body.per_cell=[2, 2]");
  EXPECT_EQ(lines[0].error, 0.2);
  EXPECT_EQ(lines[0].refined, 0.1);
  EXPECT_EQ(lines[0].share, 0.5);
  EXPECT_EQ(lines[0].outcome, "completed");
  EXPECT_EQ(lines[1].source, "space");
  EXPECT_EQ(lines[1].changed, "grid.spacing=0.5");
  EXPECT_FALSE(lines[1].refined);
  EXPECT_EQ(lines[1].share, 0);
  Plan none = plan_of_two();
  none.cases.resize(2);
  EXPECT_TRUE(budget_of(none, cases_of_two()).empty());
}

TEST(Budget, NothingIsDividedByARunThatDied) {
  for (const std::size_t dead : {0u, 2u}) {
    std::vector<StudyCase> cases = cases_of_two();
    cases[dead].outcome = "unstable";
    const auto lines = budget_of(plan_of_two(), cases);
    EXPECT_FALSE(lines.at(0).share) << dead;
    EXPECT_EQ(lines.at(0).outcome, dead == 2 ? "unstable" : "completed");
    EXPECT_EQ(lines.at(1).share.has_value(), dead == 2);
  }
}

}  // namespace
}  // namespace assay::drivers::test_budget
