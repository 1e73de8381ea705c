// SPDX-License-Identifier: BSD-3-Clause
// The battery passes what is right and names what is planted.
#include "harness/check/battery.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/harness/builtin_material.hpp"
#include "tests/harness/check/mutants.hpp"
#include "tests/harness/jaumann_material.hpp"

namespace assay::check {
namespace {

std::vector<check_tests::Subject> all_subjects() {
  std::vector<check_tests::Subject> all = check_tests::incremental_subjects();
  for (auto& subject : check_tests::total_subjects()) all.push_back(std::move(subject));
  return all;
}

std::string told(const Report& report) {
  std::string text;
  for (const Diagnosis& d : report.diagnosis) text += d.cause + ": " + d.sentence + "\n";
  for (const TestResult& t : report.tests) {
    if (t.verdict == Verdict::fail) text += "  " + t.id + ": " + t.sentence + "\n";
  }
  return text;
}

TEST(Battery, PassesWhatIsRightAndNamesWhatIsPlanted) {
  for (const auto& subject : all_subjects()) {
    for (const bool quick : {true, false}) {
      const Report report = run_battery(subject.material, {.quick = quick});
      EXPECT_EQ(report.passes() ? "" : report.diagnosis.front().cause, subject.cause)
          << subject.name << (quick ? ", quick\n" : "\n") << told(report);
    }
  }
}

/// The decisive figures are a factor of five from the thresholds on either side.
TEST(Battery, KeepsItsMargins) {
  constexpr double margin = 5;
  for (const auto& subject : all_subjects()) {
    if (subject.name == "single_precision") continue;  // its thresholds are made for it
    const Report report = run_battery(subject.material);
    bool decisive = subject.cause.empty();
    for (const TestResult& test : report.tests) {
      if (!test.measure || !test.threshold || *test.threshold == 0) {
        decisive = decisive || (test.verdict == Verdict::fail && test.cause == subject.cause);
        continue;
      }
      if (subject.cause.empty()) {
        EXPECT_LT(margin * *test.measure, *test.threshold) << subject.name << " " << test.id;
      } else if (test.verdict == Verdict::fail && test.cause == subject.cause) {
        decisive = decisive || *test.measure > margin * *test.threshold;
      }
    }
    EXPECT_TRUE(decisive) << subject.name << "\n" << told(report);
  }
}

TEST(Battery, EveryVerdictSaysWhyInOneSentence) {
  for (const auto& subject : all_subjects()) {
    std::set<std::string> ids;
    const Report report = run_battery(subject.material, {.quick = true});
    for (const TestResult& test : report.tests) {
      EXPECT_TRUE(ids.insert(test.id).second) << test.id;
      EXPECT_FALSE(test.sentence.empty()) << subject.name << " " << test.id;
      EXPECT_EQ(test.sentence.find('\n'), std::string::npos) << test.id;
      if (test.verdict != Verdict::fail) continue;
      const auto& known = all_causes();
      EXPECT_NE(std::find(known.begin(), known.end(), test.cause), known.end()) << test.cause;
    }
    EXPECT_GE(ids.size(), 25u) << subject.name;
  }
}

/// A material that refuses a step leaves the step.
TEST(Battery, ARefusedStepIsKept) {
  const Report report = run_battery(*jaumann_material(1e-9));
  ASSERT_FALSE(report.passes());
  EXPECT_EQ(report.diagnosis.front().cause, causes::refuses);
  const auto failed = std::find_if(report.tests.begin(), report.tests.end(),
                                   [](const TestResult& test) { return test.verdict == Verdict::fail; });
  ASSERT_TRUE(failed->step);
  EXPECT_GT((failed->step->F1 - Tensor::Identity()).norm(), 1e-9);
}

}  // namespace
}  // namespace assay::check
