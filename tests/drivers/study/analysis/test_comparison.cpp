// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/analysis/comparison.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "drivers/study/pages/study_pages.hpp"
#include "drivers/system/input_error.hpp"
#include "tests/drivers/study/two_methods.hpp"

namespace assay::drivers::test_comparison {
namespace {

/// The comparison of the sample with the sample that was changed.
StudyFindings of_another_program(StudyFindings study) {
  for (StudyCase& one : study.cases) one.key += one.key.empty() ? "" : "'";
  return study;
}

template <class Change>
Comparison compared_with(const Change& change) {
  StudyFindings B = of_another_program(two_method_study());
  change(B);
  return compared(two_method_study(), B);
}

const ComparedCase& labelled(const Comparison& found, const std::string& label) {
  return *std::find_if(found.cases.begin(), found.cases.end(), [&](const auto& one) { return one.label == label; });
}

TEST(Comparison, AStudyIsNotWorseThanItself) {
  const Comparison found = compared(two_method_study(), two_method_study());
  EXPECT_FALSE(found.is_worse());
  EXPECT_EQ(found.cases.size(), 9u) << "not what is n/a in both";
  EXPECT_EQ(found.count(Standing::still_fails), 1);
  EXPECT_EQ(found.costs(0) + found.errors(0), 18);
  EXPECT_TRUE(found.warnings.empty() && found.entered.empty() && found.left.empty() && found.expectations.empty());
  for (const ComparedDigit& digit : found.digits) EXPECT_FALSE(digit.changed);
  EXPECT_EQ(comparison_verdict(found), "NOTHING WORSE: 1 still fails, 8 the same");
  EXPECT_FALSE(compared({}, {}).is_worse());
}

TEST(Comparison, MatchesByValuesNotByKeysOrOrder) {
  const Comparison found = compared_with([](StudyFindings& B) {
    for (StudyCase& one : B.cases) {
      if (!one.key.empty()) one.key += "f";
      std::swap(one.values[0], one.values[1]);
      for (AxisValue& at : one.values) at.value += at.value == "0.1" ? "0" : "";
    }
    std::reverse(B.cases.begin(), B.cases.begin() + 7);
    B.front = {3, 2, 1};
    B.digits[0].best = 3, B.digits[1].best = 2, B.digits[2].best = 1;
  });
  EXPECT_EQ(found.count(Standing::only_in_a) + found.count(Standing::only_in_b), 0);
  EXPECT_FALSE(found.is_worse());
  EXPECT_TRUE(found.entered.empty() && found.left.empty());
  for (const ComparedDigit& digit : found.digits) EXPECT_FALSE(digit.changed) << digit.error;
}

TEST(Comparison, FailuresAndCasesOfOneStudy) {
  const Comparison found = compared_with([](StudyFindings& B) {
    B.cases[2] = small_case("CPDI, FLIP", 0.025, "crashed");
    B.cases[6] = small_completed("uGIMP, FLIP", 0.1, 0.2, 1);
    B.cases[1].outcome = "missing";
    B.cases[8] = small_completed("Cheat", 0.05, 1e-6, 1);
    B.cases.push_back(small_completed("New", 0.1, 0.1, 1));
  });
  EXPECT_EQ(labelled(found, "CPDI, FLIP, grid.spacing=0.025").standing, Standing::new_failure);
  EXPECT_EQ(labelled(found, "uGIMP, FLIP, grid.spacing=0.1").standing, Standing::fixed);
  EXPECT_EQ(labelled(found, "CPDI, FLIP, grid.spacing=0.05").standing, Standing::only_in_a);
  EXPECT_EQ(found.count(Standing::only_in_b), 2);
  EXPECT_TRUE(found.is_worse());
  EXPECT_EQ(comparison_verdict(found),
            "WORSE: 1 new failure, 1 case only in A, 1 fixed, 2 cases only in B, 6 the same");
  EXPECT_FALSE(
      compared_with([](StudyFindings& B) { B.cases.push_back(small_case("New", 0.1, "unstable")); }).is_worse());
  EXPECT_FALSE(
      compared_with([](StudyFindings& B) { B.cases[6] = small_completed("uGIMP, FLIP", 0.1, 1, 1); }).is_worse());
}

TEST(Comparison, AMotionThatStandsStillHasNoRelativeError) {
  const auto still = [](StudyFindings study) {
    for (StudyCase& one : study.cases) {
      if (one.completed()) one.error.reset(), one.figures["error.l2_max"] = 0.0;
    }
    return study;
  };
  const StudyFindings moving = two_method_study(), other = of_another_program(still(moving));
  const Comparison stopped = compared(moving, other), set_off = compared(other, moving);
  EXPECT_EQ(stopped.errors(1) + stopped.errors(-1) + set_off.errors(1) + set_off.errors(-1), 0);
  ASSERT_FALSE(stopped.warnings.empty());
  EXPECT_TRUE(stopped.warnings[0].starts_with("B: the exact displacement is zero in ")) << stopped.warnings[0];
  EXPECT_EQ(compared_with([](StudyFindings& B) { B.cases[0].error.reset(); }).errors(1), 1) << "not finite any more";
}

TEST(Comparison, AFifthSlowerIsWorseAndAFifthFasterIsNot) {
  const Comparison slower = compared_with([](StudyFindings& B) { set_clock(B.cases[1], {9.5, 9.6, 9.7}); });
  EXPECT_TRUE(slower.is_worse());
  EXPECT_EQ(slower.costs(1), 1);
  EXPECT_NE(comparison_verdict(slower).find("1 slower"), std::string::npos);
  const Comparison faster = compared_with([](StudyFindings& B) { set_clock(B.cases[1], {6.6, 6.7, 6.8}); });
  EXPECT_FALSE(faster.is_worse());
  EXPECT_EQ(faster.costs(-1), 1);
  EXPECT_EQ(compared_with([](StudyFindings& B) { set_clock(B.cases[1], {9, 9.6, 12}); }).costs(1), 0) << "noise";
  EXPECT_EQ(compared_with([](StudyFindings& B) { set_clock(B.cases[1], {8.3, 8.3, 8.3}); }).costs(1), 0) << "floor";
}

TEST(Comparison, OfTheSameKeyOrBesideOthersTimesAreNotJudged) {
  StudyFindings same = two_method_study();
  set_clock(same.cases[1], {9.5, 9.6, 9.7});
  const Comparison found = compared(two_method_study(), same);
  EXPECT_FALSE(found.is_worse());
  EXPECT_FALSE(labelled(found, "CPDI, FLIP, grid.spacing=0.05").cost_judged);
  ASSERT_EQ(found.warnings.size(), 1u);
  EXPECT_NE(found.warnings[0].find("1 case was slower or faster with the same key"), std::string::npos);
  EXPECT_FALSE(compared_with([](StudyFindings& B) {
                 set_clock(B.cases[1], {9.5, 9.6, 9.7});
                 B.cases[1].clock.others = {1, 1, 1};
               }).is_worse());
}

TEST(Comparison, WithoutACommonCaseIsRefused) {
  StudyFindings other = two_method_study();
  for (StudyCase& one : other.cases) one.values[0].axis = "model";
  EXPECT_THROW(compared(two_method_study(), other), InputError);
}

TEST(Comparison, WithOneRepeatTheNoiseIsNotKnown) {
  const Comparison found = compared_with([](StudyFindings& B) { set_clock(B.cases[1], {9.6}); });
  EXPECT_EQ(found.costs(1), 0);
  EXPECT_FALSE(labelled(found, "CPDI, FLIP, grid.spacing=0.05").noise_measured);
  ASSERT_EQ(found.warnings.size(), 1u);
  EXPECT_EQ(found.warnings[0], "1 case was timed once: no measure of noise, a difference counts beyond 25 %");
  EXPECT_EQ(compared_with([](StudyFindings& B) { set_clock(B.cases[1], {10.1}); }).costs(1), 1);
}

TEST(Comparison, WarnsOfClocksThatCannotBeCompared) {
  const Comparison found = compared_with([](StudyFindings& B) {
    for (StudyCase& one : B.cases) {
      one.clock.machine = "another machine, 64 cores";
      if (one.cost) set_clock(one, {9 * *one.cost, 9.1 * *one.cost});
    }
    B.cases[0].clock.alone = false;
    B.cases[1].clock.others = {0.8, 10, 11};
    B.cases[2].cost.reset();
  });
  EXPECT_FALSE(found.is_worse()) << "times of different machines";
  ASSERT_EQ(found.warnings.size(), 5u);
  EXPECT_EQ(found.warnings[0], "7 cases were timed on different machines: times are shown and not judged");
  EXPECT_EQ(found.warnings[1], "1 case was not timed alone");
  EXPECT_EQ(found.warnings[2],
            "1 case was disturbed, others kept more than 15 % of the machine busy: times are shown and not judged");
  EXPECT_TRUE(found.warnings[3].starts_with("B: times were measured while other programs used ")) << found.warnings[3];
  EXPECT_EQ(found.warnings[4], "the cost of 1 case is known in only one of the studies");
}

TEST(Comparison, ErrorsAreComparedBeyondRounding) {
  const auto errors = [](double factor, double shift) {
    return compared_with([&](StudyFindings& B) { B.cases[4].error = *B.cases[4].error * factor + shift; });
  };
  EXPECT_EQ(errors(1 + 1e-8, 0).errors(0), 9);
  EXPECT_EQ(errors(1.00001, 0).errors(1), 1);
  EXPECT_TRUE(errors(1.00001, 0).is_worse());
  EXPECT_EQ(errors(0.9, 0).errors(-1), 1);
  EXPECT_FALSE(errors(0.9, 0).is_worse());
  EXPECT_EQ(ratio_text(labelled(errors(1.00001, 0), "B2, AFLIP, grid.spacing=0.05").error), "1.00001");
  StudyFindings A = two_method_study(), B = two_method_study();
  A.cases[4].error = 1e-13, B.cases[4].error = 8e-12;
  EXPECT_EQ(compared(A, B).errors(0), 9) << "rounding itself";
  B.cases[4].error.reset();
  EXPECT_TRUE(compared(A, B).is_worse()) << "no error any more";
  EXPECT_EQ(compared(B, A).errors(-1), 1) << "an error at last";
}

TEST(Comparison, SaysWhetherTheCheapestChanged) {
  const Comparison found = compared_with([](StudyFindings& B) {
    set_clock(B.cases[4], {90, 91, 89});
    B.digits[1].best = 2;
    B.digits[2].best.reset();
    B.front = {3, 2};
  });
  ASSERT_EQ(found.digits.size(), 3u);
  EXPECT_FALSE(found.digits[0].changed);
  EXPECT_TRUE(found.digits[1].changed && found.digits[1].told_apart);
  EXPECT_EQ(found.digits[1].b, "CPDI, FLIP, grid.spacing=0.025");
  EXPECT_TRUE(found.digits[2].changed);
  EXPECT_EQ(found.digits[2].b, "");
  EXPECT_EQ(found.entered, std::vector<std::string>{"CPDI, FLIP, grid.spacing=0.025"});
  EXPECT_EQ(found.left.size(), 2u);
  const Comparison tied = compared_with([](StudyFindings& B) {
    set_clock(B.cases[2], {3.95, 3.96, 3.97});
    B.digits[1].best = 2;
  });
  EXPECT_TRUE(tied.digits[1].changed);
  EXPECT_FALSE(tied.digits[1].told_apart);
}

TEST(Comparison, ExpectationsThatFailNow) {
  const auto broken = [](StudyFindings& B) { B.expect[0].outcome.holds = false; };
  EXPECT_TRUE(compared_with(broken).is_worse());
  StudyFindings A = two_method_study();
  broken(A);
  const Comparison mended = compared(A, two_method_study());
  EXPECT_FALSE(mended.is_worse());
  EXPECT_EQ(mended.broken(true), 1);
}

TEST(Comparison, DifferentFiguresCannotBeCompared) {
  EXPECT_THROW(compared_with([](StudyFindings& B) { B.error_key = "error.l2_max"; }), InputError);
  EXPECT_THROW(compared_with([](StudyFindings& B) { B.cost_key = "cpu_s"; }), InputError);
}

// No case in noise of 2 %, three repeats, 200 pairs of studies of 8 timed cases: the rate of docs/studies.md.
TEST(Comparison, NoiseRaisesNoAlarm) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0, 0.02);
  const auto measured = [&](StudyFindings study) {
    for (StudyCase& one : study.cases) {
      const double cost = one.cost.value_or(0);
      if (one.cost)
        set_clock(one,
                  {cost * std::exp(noise(random)), cost * std::exp(noise(random)), cost * std::exp(noise(random))});
    }
    return study;
  };
  int alarms = 0;
  for (int k = 0; k < 200; ++k)
    alarms +=
        compared(measured(two_method_study()), measured(of_another_program(two_method_study()))).is_worse() ? 1 : 0;
  EXPECT_LE(alarms, 2);
}

Comparison everything(StudyFindings& B) {
  set_clock(B.cases[1], {10, 10.1, 9.9});
  B.cases[4].error = 9.5e-3;
  B.cases[2] = small_case("CPDI, FLIP", 0.025, "material_failed");
  B.cases[6] = small_completed("uGIMP, FLIP", 0.1, 0.2, 0.3);
  B.cases.push_back(
      small_completed("A method | with a long name, and awordthatislongerthanthecolumnofthetable", 0.1, 1, 1));
  B.digits[1].best = 1;
  B.front = {3, 4};
  B.expect[0].outcome.holds = false;
  B = of_another_program(B);
  return compared(two_method_study(), B);
}

TEST(Comparison, TextKeepsToEightyColumns) {
  StoredStudy A{"a", "a/study.json", two_method_study()}, B{"b", "b/study.json", two_method_study()};
  const Comparison found = everything(B.findings);
  for (const bool all : {false, true}) {
    std::istringstream lines(comparison_text(A, B, found, all));
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80u) << line;
  }
  const std::string text = comparison_text(A, B, found);
  for (const char* part : {"NEW FAILURE", "LESS ACCURATE", "SLOWER", "fixed", "only in B", "FAILS now", "\nWORSE: "})
    EXPECT_NE(text.find(part), text.npos) << part << "\n" << text;
  EXPECT_EQ(text.find("\nCheat"), text.npos) << "the same";
  EXPECT_NE(comparison_text(A, B, found, true).find("\nCheat"), text.npos);
}

TEST(Comparison, MarkdownAndJsonTellAll) {
  StoredStudy A{"a", "a/study.json", two_method_study()}, B{"b", "b/study.json", two_method_study()};
  const Comparison found = everything(B.findings);
  const std::string page = comparison_markdown(A, B, found);
  EXPECT_TRUE(page.starts_with("**WORSE: ")) << page;
  EXPECT_NE(page.find("| CPDI, FLIP, grid.spacing=0.05 | SLOWER | 0.02 | 0.02 | 1 | 8 | 10 | 1.25 | 5 % |"), page.npos);
  EXPECT_NE(page.find("A method \\| with"), page.npos);
  const auto json = nlohmann::json::parse(comparison_json(A, B, found));
  EXPECT_EQ(json["worse"], true);
  EXPECT_EQ(json["cases"].size(), 10u);
  EXPECT_EQ(json["cases"][1]["cost"]["trend"], 1);
  EXPECT_EQ(json["cases"][2]["standing"], "new_failure");
  EXPECT_TRUE(json["cases"][2]["error"]["b"].is_null());
  EXPECT_EQ(json["digits"][1]["changed"], true);
  EXPECT_EQ(json["expectations"][0]["holds"], false);
}

}  // namespace
}  // namespace assay::drivers::test_comparison
