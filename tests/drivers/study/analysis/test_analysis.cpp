// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/analysis/findings.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "drivers/study/pages/words.hpp"

namespace assay::drivers::test_analysis {
namespace {

StudyCase eligible_case(double error, Figure cost) {
  StudyCase one;
  one.outcome = "completed";
  one.error = error, one.cost = cost;
  one.eligible = true;
  return one;
}

/// A completed case as a folder gives it: figures and clock, nothing found yet.
StudyCase read_case(const std::string& method, double h, Figure error, std::vector<double> seconds = {1}) {
  StudyCase one;
  one.values = {{"method", method}, {"grid.spacing", std::to_string(h)}};
  one.label = method + " on " + std::to_string(h);
  one.series = method;
  one.resolution = h;
  one.outcome = error ? "completed" : "unstable";
  if (error) one.figures["error.relative"] = *error;
  one.figures["work.particle_steps"] = 100 / h;
  one.figures["uses_exact_solution"] = false;
  one.clock.alone = !seconds.empty();
  one.clock.others.assign(seconds.size(), 0.0);
  one.clock.step_s = std::move(seconds);
  one.clock.machine = "a machine, 2 cores";
  return one;
}

StudyFindings found_in(std::vector<StudyCase> cases, const Study& study) {
  Plan plan;
  plan.study = study;
  return analysed(plan, std::move(cases));
}

StudyFindings found_in(std::vector<StudyCase> cases) {
  const Study study;
  return found_in(std::move(cases), study);
}

/// Errors C h^2 on grids that are halved, costs 1, 8, 64.
std::vector<StudyCase> second_order_cases(const std::string& method = "a", double c = 1) {
  return {read_case(method, 0.4, c * 0.16, {1}), read_case(method, 0.2, c * 0.04, {8}),
          read_case(method, 0.1, c * 0.01, {64})};
}

/// The front by its definition: no other is at least as good in both and better in one; of equals the first.
std::vector<std::size_t> front_by_definition(const std::vector<StudyCase>& cases, Figure StudyCase::*cost) {
  std::vector<std::size_t> front;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (!cases[i].eligible || !(cases[i].*cost)) continue;
    bool beaten = false;
    for (std::size_t j = 0; j < cases.size(); ++j) {
      if (!cases[j].eligible || !(cases[j].*cost)) continue;
      const double more = *(cases[j].*cost) - *(cases[i].*cost), worse = *cases[j].error - *cases[i].error;
      beaten = beaten || (more <= 0 && worse <= 0 && (more < 0 || worse < 0 || j < i));
    }
    if (!beaten) front.push_back(i);
  }
  std::sort(front.begin(), front.end(),
            [&](std::size_t a, std::size_t b) { return *(cases[a].*cost) < *(cases[b].*cost); });
  return front;
}

TEST(Analysis, TheFrontIsThatOfTheDefinition) {
  std::mt19937 random(7);
  int longer = 0;
  for (int round = 0; round < 500; ++round) {
    std::vector<StudyCase> cases;
    for (unsigned i = random() % 30; i > 0; --i) {
      StudyCase one = eligible_case(random() % 8, random() % 5 == 0 ? Figure() : Figure(random() % 8));  // many ties
      if (random() % 6 == 0) one.eligible = false;
      if (random() % 3 > 0) one.work = random() % 8;
      cases.push_back(one);
    }
    for (const auto cost : {&StudyCase::cost, &StudyCase::work}) {
      const auto front = pareto_front(cases, cost);
      ASSERT_EQ(front, front_by_definition(cases, cost)) << round;
      longer += front.size() > 2 ? 1 : 0;
    }
  }
  EXPECT_GT(longer, 100) << "the data tell something";
  EXPECT_TRUE(pareto_front({}, &StudyCase::cost).empty());
}

/// Cases of one series, in the order given, the coarsest first.
Figure cost_in(const std::vector<StudyCase>& cases, double error) {
  StudySeries series;
  for (std::size_t i = 0; i < cases.size(); ++i) series.cases.push_back(i);
  return cost_at(cases, series, error);
}

TEST(Analysis, CostsBetweenResolutionsLieOnTheLineInLogarithms) {
  // error = 2 cost^(-2/3): cost = (2 / error)^(3/2) everywhere between
  std::vector<StudyCase> cases;
  for (const double cost : {1.0, 10.0, 300.0}) cases.push_back(eligible_case(2 * std::pow(cost, -2.0 / 3), cost));
  for (const double error : {1.9, 1.0, 0.5, 0.2, 0.1, 0.05}) {
    EXPECT_NEAR(cost_in(cases, error).value(), std::pow(2 / error, 1.5), 1e-12 * std::pow(2 / error, 1.5)) << error;
  }
  EXPECT_EQ(cost_in(cases, 2).value(), 1);
  EXPECT_NEAR(cost_in(cases, *cases[2].error).value(), 300, 1e-9);
  EXPECT_EQ(cost_in(cases, 5).value(), 1) << "the coarsest is better than asked";
  EXPECT_FALSE(cost_in(cases, 0.99 * *cases[2].error)) << "nothing is extrapolated";
  EXPECT_FALSE(cost_in({}, 1));
}

TEST(Analysis, OfAnErrorThatIsMetTwiceTheCheaperCounts) {
  const std::vector<StudyCase> cases{eligible_case(1, 1), eligible_case(0.01, 100), eligible_case(1, 1000),
                                     eligible_case(1e-4, 1e4)};
  EXPECT_NEAR(cost_in(cases, 0.1).value(), 10, 1e-12);
  EXPECT_NEAR(cost_in(cases, 1e-3).value(), std::pow(10, 3.75), 1e-9) << "only the last two span it";
  const std::vector<StudyCase> falling{eligible_case(1, 1000), eligible_case(0.01, 10)};
  EXPECT_NEAR(cost_in(falling, 0.1).value(), 100, 1e-10) << "finer and cheaper";
}

TEST(Analysis, CasesThatAreNotEligibleAreSkippedInASeries) {
  std::vector<StudyCase> cases{eligible_case(1, 1), eligible_case(1e-9, 2), eligible_case(0.01, 100)};
  cases[1].eligible = false;
  EXPECT_NEAR(cost_in(cases, 0.1).value(), 10, 1e-12);
  cases[1].eligible = true, cases[1].cost.reset();
  EXPECT_NEAR(cost_in(cases, 0.1).value(), 10, 1e-12);
  EXPECT_FALSE(cost_in({cases[1]}, 1));
}

TEST(Analysis, AnErrorOfZeroAndOfAStepAreMet) {
  EXPECT_EQ(cost_in({eligible_case(1, 1), eligible_case(0, 100)}, 0.1), 100) << "there is no line to zero";
  EXPECT_EQ(cost_in({eligible_case(1, 1), eligible_case(1, 100)}, 1), 1);
}

TEST(Analysis, FillsInErrorCostAndWork) {
  Study study;
  StudyCase one = read_case("a", 0.1, 0.02, {3, 1, 2.5, 2});
  one.clock.cpu_s = {7}, one.clock.wall_s = {};
  one.figures["error.l2_max"] = 0.5;
  StudyCase found = found_in({one}).cases[0];
  EXPECT_EQ(found.error, 0.02);
  EXPECT_EQ(found.cost, 2.25) << "the median of four";
  EXPECT_DOUBLE_EQ(found.cost_spread.value(), 1 / 2.25) << "half the range over it";
  EXPECT_EQ(found.work, 1000);
  EXPECT_TRUE(found.eligible);
  EXPECT_TRUE(found.on_front);
  one.clock.step_s = {3, 1, 2.5};
  EXPECT_EQ(found_in({one}).cases[0].cost, 2.5) << "the median of three";
  study.cost = "cpu_s", study.error = "error.l2_max";
  found = found_in({one}, study).cases[0];
  EXPECT_EQ(found.error, 0.5);
  EXPECT_EQ(found.cost, 7);
  EXPECT_FALSE(found.cost_spread) << "one run has none";
  study.cost = "wall_s";
  EXPECT_FALSE(found_in({one}, study).cases[0].cost);
  study.cost = "work.particle_steps";
  EXPECT_EQ(found_in({one}, study).cases[0].cost, 1000);
  EXPECT_FALSE(found_in({one}, study).cases[0].cost_spread);
}

TEST(Analysis, AClockThatWasNotAloneTellsNoCost) {
  StudyCase one = read_case("a", 0.1, 0.02, {1, 2});
  one.clock.alone = false;
  one.figures["step_cpu_s"] = 1.0;
  const StudyFindings found = found_in({one});
  EXPECT_FALSE(found.cases[0].cost);
  EXPECT_TRUE(found.cases[0].eligible) << "by its work";
  EXPECT_TRUE(found.front.empty());
  EXPECT_EQ(found.work_front, std::vector<std::size_t>{0});
}

TEST(Analysis, EligibleIsWhatCompletedByItself) {
  std::vector<StudyCase> cases(6, read_case("a", 0.1, 0.02));
  cases[1].figures["uses_exact_solution"] = true;
  cases[2].budget = true;
  cases[3].outcome = "unstable";
  cases[4].figures["error.relative"] = std::numeric_limits<double>::quiet_NaN();
  cases[5].clock = {}, cases[5].figures.erase("work.particle_steps");
  const StudyFindings found = found_in(cases);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(found.cases[i].eligible, i == 0) << i;
  EXPECT_FALSE(found.cases[3].error) << "of a run that ended early";
  EXPECT_TRUE(found.cases[1].error) << "though it is in no front";
  EXPECT_EQ(found.front, std::vector<std::size_t>{0});
}

TEST(Analysis, SeriesGoFromTheCoarsestAndHaveTheirOrders) {
  std::vector<StudyCase> cases = second_order_cases("b", 3);
  std::swap(cases[0], cases[2]);
  const auto more = second_order_cases("a");
  cases.insert(cases.end(), more.begin(), more.end());
  cases[4].outcome = "unstable";
  StudyCase budget = cases[0];
  budget.budget = true;
  cases.push_back(budget);
  const StudyFindings found = found_in(cases);
  ASSERT_EQ(found.series.size(), 2u);
  const StudySeries &b = found.series[0], &a = found.series[1];
  EXPECT_EQ(b.name, "b");
  EXPECT_EQ(b.cases, (std::vector<std::size_t>{2, 1, 0}));
  ASSERT_EQ(b.pairwise.size(), 3u);
  EXPECT_FALSE(b.pairwise[0]);
  EXPECT_NEAR(b.pairwise[1].value(), 2, 1e-12);
  EXPECT_NEAR(b.pairwise[2].value(), 2, 1e-12);
  EXPECT_NEAR(b.fit.value().order, 2, 1e-12);
  EXPECT_EQ(b.asymptotic, StudySeries::Range::reached);
  EXPECT_FALSE(b.sentence.empty());
  EXPECT_EQ(a.cases, (std::vector<std::size_t>{3, 4, 5})) << "those that died, too";
  EXPECT_FALSE(a.pairwise[1]);
  EXPECT_NEAR(a.pairwise[2].value(), 2, 1e-12) << "from the completed one before";
  EXPECT_NEAR(a.fit.value().order, 2, 1e-12);
  EXPECT_EQ(a.asymptotic, StudySeries::Range::unknown);
}

TEST(Analysis, PublishedOrdersStandBesideTheSeriesThatAreMeant) {
  std::vector<StudyCase> cases = second_order_cases("a");
  for (const char* method : {"b", "c"}) {
    const auto more = second_order_cases(method);
    cases.insert(cases.end(), more.begin(), more.end());
  }
  Study study;
  const auto where = [](const std::string& flow) { return read_selection(read_yaml(flow, "f"), "where"); };
  study.published = {{where("{method: [a, b]}"), 0.8, "one"},
                     {where("{method: b, grid.spacing: {below: 0.15}}"), 1.5, "two"}};
  const StudyFindings found = found_in(cases, study);
  EXPECT_EQ(found.series[0].published, 0.8);
  EXPECT_EQ(found.series[0].source, "one");
  EXPECT_EQ(found.series[1].published, 1.5) << "the later line; one of its cases is enough";
  EXPECT_EQ(found.series[1].source, "two");
  EXPECT_FALSE(found.series[2].published);
}

TEST(Analysis, DigitsOfARelativeErrorBeginAtTenPercent) {
  const StudyFindings found = found_in({read_case("a", 0.4, 1.6, {1}), read_case("a", 0.2, 0.16, {10}),
                                        read_case("a", 0.1, 0.016, {100}), read_case("a", 0.05, 0.0016, {1000})});
  ASSERT_EQ(found.digits.size(), 3u);
  EXPECT_EQ(found.digits[0].error, 0.1);
  EXPECT_EQ(found.digits[0].best, 2u);
  EXPECT_EQ(found.digits[0].cost, 100);
  EXPECT_NEAR(found.digits[0].interpolated.value(), 16, 1e-10) << "error = 1.6 / cost";
  EXPECT_FALSE(found.digits[0].factor);
  EXPECT_EQ(found.digits[1].error, 0.01);
  EXPECT_EQ(found.digits[1].best, 3u);
  EXPECT_NEAR(found.digits[1].interpolated.value(), 160, 1e-9);
  EXPECT_NEAR(found.digits[1].factor.value(), 10, 1e-10);
  EXPECT_EQ(found.digits[1].series, "a");
  EXPECT_EQ(found.digits[2].error, 0.001) << "the first that none reaches";
  EXPECT_FALSE(found.digits[2].best);
  EXPECT_FALSE(found.digits[2].interpolated);
  EXPECT_FALSE(found.digits[2].factor);
}

TEST(Analysis, DigitsOfOtherErrorsBeginWhereTheCasesDo) {
  Study study;
  study.error = "error.l2_max";
  std::vector<StudyCase> cases{read_case("a", 0.2, 1), read_case("a", 0.1, 1, {10})};
  cases[0].figures["error.l2_max"] = 250.0, cases[1].figures["error.l2_max"] = 3.0;
  const StudyFindings found = found_in(cases, study);
  ASSERT_EQ(found.digits.size(), 3u);
  EXPECT_EQ(found.digits[0].error, 100);
  EXPECT_EQ(found.digits[1].error, 10);
  EXPECT_EQ(found.digits[2].error, 1);
  EXPECT_FALSE(found.digits[2].best);
}

TEST(Analysis, ThereIsAlwaysALevelThatNoCaseReaches) {
  const auto levels = [](double error) {
    std::vector<double> all;
    for (const StudyDigit& digit : found_in({read_case("a", 0.1, error)}).digits) all.push_back(digit.error);
    return all;
  };
  EXPECT_EQ(levels(0.01), (std::vector<double>{0.01, 0.001})) << "a power of ten itself";
  EXPECT_EQ(levels(0.02), std::vector<double>{0.01});
  EXPECT_EQ(levels(0.5), std::vector<double>{0.1});
  EXPECT_EQ(levels(3), std::vector<double>{0.1}) << "none of use, yet with an error and a cost";
  EXPECT_EQ(levels(250), std::vector<double>{0.1});
  EXPECT_EQ(levels(0), std::vector<double>{}) << "no digit is the last";
}

TEST(Analysis, TheCheapestOfTwoSeriesStandsAtEachDigit) {
  std::vector<StudyCase> cases{read_case("coarse", 0.2, 0.09, {1}), read_case("coarse", 0.1, 0.009, {100}),
                               read_case("fine", 0.2, 0.05, {4}), read_case("fine", 0.1, 0.0005, {40})};
  const StudyFindings found = found_in(cases);
  ASSERT_EQ(found.digits.size(), 3u);
  EXPECT_EQ(found.digits[0].error, 0.01);
  EXPECT_EQ(found.digits[0].best, 3u);
  EXPECT_EQ(found.digits[0].series, "fine");
  EXPECT_NEAR(found.digits[0].interpolated.value(), 4 * std::pow(10, std::log(5.0) / std::log(100.0)), 1e-9);
}

TEST(Analysis, WarnsOfWhatMakesCostsDoubtful) {
  std::vector<StudyCase> cases = second_order_cases();
  EXPECT_TRUE(found_in(cases).warnings.empty());
  cases[0].clock = {};
  cases[1].clock.others = {0.31};  // of 2 cores; the bound is 15 %
  cases[2].clock.machine = "another, 8 cores";
  StudyCase missing = cases[0];
  missing.outcome = "missing";
  cases.push_back(missing);
  const StudyFindings found = found_in(cases);
  ASSERT_EQ(found.warnings.size(), 4u);
  EXPECT_EQ(found.warnings[0],
            "1 case was completed and not timed: without a cost in step_cpu_s only particle-steps are compared");
  EXPECT_EQ(
      found.warnings[1],
      "times were measured while other programs used 7.8 % of the processors, and more than 15 % beside 1 of 2 cases: "
      "compare them with care");
  EXPECT_EQ(found.warnings[2], "the cases were run on different machines: their costs cannot be compared");
  EXPECT_TRUE(found.warnings[3].starts_with("1 ")) << found.warnings[3];
  EXPECT_EQ(found.machines, (std::vector<std::string>{"a machine, 2 cores", "another, 8 cores"}));
  EXPECT_FALSE(found.holds()) << "a case is missing";
}

TEST(Analysis, QuietMachinesAndCountedCostsAreNotWarnedOf) {
  std::vector<StudyCase> cases = second_order_cases();
  cases[1].clock.others = {0.29, 0.0, 5.0};
  EXPECT_TRUE(found_in(cases).warnings.empty()) << "the median counts";
  for (StudyCase& one : cases) one.clock = {};
  Study study;
  study.cost = "work.particle_steps";
  EXPECT_TRUE(found_in(cases, study).warnings.empty());
}

TEST(Analysis, CarriesWhatTheStudySays) {
  Study study;
  study.title = "T", study.question = "Q?", study.text = "title: T\n", study.sha256 = "abc";
  study.refine = "grid.spacing", study.error = "error.l2_max", study.cost = "work.bytes";
  study.axes = {{"method", {}, {}, false, {}}, {"grid.spacing", {}, {}, true, {}}};
  const StudyFindings found = found_in({}, study);
  EXPECT_EQ(found.title, "T");
  EXPECT_EQ(found.question, "Q?");
  EXPECT_EQ(found.study_yaml, "title: T\n");
  EXPECT_EQ(found.provenance.scene_sha256, "abc");
  EXPECT_EQ(found.refine_key, "grid.spacing");
  EXPECT_EQ(found.error_key, "error.l2_max");
  EXPECT_EQ(found.error_unit, "m");
  EXPECT_EQ(found.cost_key, "work.bytes");
  EXPECT_EQ(found.cost_unit, "B");
  EXPECT_EQ(found.axes, (std::vector<std::string>{"method", "grid.spacing"}));
  EXPECT_TRUE(found.digits.empty());
  EXPECT_TRUE(found.holds());
}

}  // namespace
}  // namespace assay::drivers::test_analysis
