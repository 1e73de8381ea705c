// SPDX-License-Identifier: BSD-3-Clause
// The battery passes what is right and names what is planted.
#include "harness/check/battery.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>

#include "tests/harness/builtin_material.hpp"
#include "tests/harness/check/all_causes.hpp"
#include "tests/harness/check/margins.hpp"
#include "tests/harness/check/mutants.hpp"
#include "tests/harness/jaumann_material.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::check::test_battery {
namespace {

using check_tests::all_subjects;
using check_tests::battery_of;
using check_tests::Margin;

std::string told(const Report& report) {
  std::string text;
  for (const Diagnosis& d : report.diagnosis) text += d.cause + ": " + d.sentence + "\n";
  for (const TestResult& t : report.tests) {
    if (t.verdict == Verdict::fail) text += "  " + t.id + ": " + t.sentence + "\n";
  }
  return text;
}

void expect_named(const check_tests::Subject& subject, const Report& report, const std::string& how) {
  EXPECT_EQ(report.passes() ? "" : report.diagnosis.front().cause, subject.cause) << subject.name << ", " << how << "\n"
                                                                                  << told(report);
}

/// The decisive figures are a factor of five from the thresholds on either side.
void expect_wide(const Margin& margin) {
  constexpr double factor = 5;
  if (margin.cause.empty()) {
    EXPECT_LT(factor * margin.figure, 1) << margin.subject << " " << margin.test;
  } else {
    EXPECT_FALSE(margin.test.empty()) << margin.subject;
    EXPECT_TRUE(margin.figure == 0 || margin.figure > factor) << margin.subject << " " << margin.figure;
  }
}

void expect_sentences(const std::string& subject, const Report& report) {
  std::set<std::string> ids;
  for (const TestResult& test : report.tests) {
    EXPECT_TRUE(ids.insert(test.id).second) << test.id;
    EXPECT_FALSE(test.sentence.empty()) << subject << " " << test.id;
    EXPECT_EQ(test.sentence.find('\n'), std::string::npos) << test.id;
    if (test.verdict != Verdict::fail) continue;
    const auto& known = all_causes();
    EXPECT_NE(std::find(known.begin(), known.end(), test.cause), known.end()) << test.cause;
  }
  EXPECT_GE(ids.size(), 25u) << subject;
}

/// The rows between the marks of docs/check.md.
std::vector<std::string> documented_margins() {
  std::ifstream in(tree_folder() + "/docs/check.md");
  std::vector<std::string> rows;
  bool inside = false;
  for (std::string line; std::getline(in, line);) {
    if (line == "<!-- margins end -->") inside = false;
    const bool is_row = line.starts_with("| ") && !line.starts_with("| ---") &&
                        line.find("least figure") == line.npos && line.find("largest figure") == line.npos;
    if (inside && is_row) rows.push_back(line);
    if (line == "<!-- margins -->") inside = true;
  }
  return rows;
}

void expect_documented(const std::vector<Margin>& margins) {
  const std::vector<std::string> documented = documented_margins();
  std::string expected;
  std::size_t agree = 0, count = 0;
  for (const auto& row : margin_rows(margins)) {
    expected += row.text() + "\n";
    if (count < documented.size() && row.agrees_with(documented[count])) ++agree;
    ++count;
  }
  EXPECT_TRUE(agree == count && count == documented.size()) << "docs/check.md is to hold these rows:\n" << expected;
}

void expect_quickly_named(const std::vector<check_tests::Subject>& subjects) {
  for (const auto& subject : subjects) {
    const Report quick = battery_of(subject, {.effort = {.quick = true}});
    expect_named(subject, quick, "quick");
    expect_sentences(subject.name, quick);
  }
}

TEST(Battery, NamesWhatIsPlantedInAFractionOfTheTime) { expect_quickly_named(check_tests::few_subjects()); }
TEST(LongBattery, NamesWhatIsPlantedInAFractionOfTheTime) { expect_quickly_named(all_subjects()); }

/// One test for all of it: the batteries are what takes the time.
TEST(LongBattery, NamesWhatIsPlantedAndKeepsTheMarginsOfTheDocuments) {
  std::vector<Margin> margins;
  for (const auto& subject : all_subjects()) {
    const Report full = battery_of(subject);
    expect_named(subject, full, "full");
    expect_sentences(subject.name, full);
    margins.push_back(margin_of(subject, full));
    expect_wide(margins.back());
  }
  expect_documented(margins);
}

TEST(BatteryNegativeControl, AMarginThatIsWrongIsSeen) {
  const check_tests::MarginRow row{"clock", 3, 40, {{"late", "soil", "clock", "clock", 40}}};
  EXPECT_EQ(row.text(), "| clock | 3 | 40 | `late` |");
  EXPECT_TRUE(row.agrees_with(row.text()));
  EXPECT_TRUE(row.agrees_with("| clock | 3 | 70 | `late` |"));
  EXPECT_FALSE(row.agrees_with("| clock | 3 | 100 | `late` |"));
  EXPECT_FALSE(row.agrees_with("| clock | 2 | 40 | `late` |"));
  EXPECT_FALSE(row.agrees_with("| clock | 3 | 40 | `early` |"));
  EXPECT_FALSE(row.agrees_with("| overrun | 3 | 40 | `late` |"));
}

TEST(Battery, EveryDiagnosisIsPlantedOnTwoKindsOfModel) {
  for (const std::string& cause : all_causes()) {
    const std::set<std::string> of_the_program{
        causes::ends_process,  causes::disturbs_process, causes::other_stress,      causes::state_undeclared,
        causes::host_counters, causes::kept_by_element,  causes::properties_missing};
    if (of_the_program.count(cause) == 1) continue;
    if (cause == causes::not_reached || cause == causes::refuses_length) continue;  // of what is asked for: test_scope
    std::set<std::string> kinds;
    for (const auto& subject : all_subjects()) {
      if (subject.cause == cause) kinds.insert(subject.material.table().name);
    }
    EXPECT_GE(kinds.size(), 2u) << cause;
  }
}

/// Rounding of single precision is no defect, whatever the moduli.
TEST(LongBattery, PassesSinglePrecisionAtAnyModuli) {
  const auto all = check_tests::total_mutants::subjects();
  const auto single =
      std::find_if(all.begin(), all.end(), [](const auto& subject) { return subject.name == "single_precision"; });
  ASSERT_NE(single, all.end());
  for (int k = 0; k < 40; ++k) {
    const double mu = std::pow(10, -3 + 0.3 * k), lambda = mu * (0.05 + 0.12 * k);
    const Material material(&single->material.table(), {{"defect", 1}, {"mu", mu}, {"lambda", lambda}});
    const Report report = run_battery(material, {.effort = {.quick = true}});
    EXPECT_TRUE(report.passes()) << "mu " << mu << ", lambda " << lambda << "\n" << told(report);
  }
}

/// What is declared to grow is not asked for what growth cannot hold.
TEST(Battery, PassesWhatIsDeclaredToGrow) {
  int count = 0;
  for (const auto& subject : all_subjects()) {
    if (subject.cause != causes::grows) continue;
    ++count;
    assay_material table = subject.material.table();
    table.flags |= ASSAY_GROWS;
    const Report report = run_battery(Material(&table, subject.material.named_parameters()));
    EXPECT_TRUE(report.passes()) << subject.name << "\n" << told(report);
  }
  EXPECT_EQ(count, 2);
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
}  // namespace assay::check::test_battery
