// SPDX-License-Identifier: BSD-3-Clause
// What the battery has found, as text of 80 columns, JSON and JUnit's XML.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "drivers/system/terminal.hpp"
#include "harness/check/battery.hpp"

namespace assay::drivers {

/// What the host of a foreign model holds constant, and the answer of a step depends on all the same.
struct Dependence {
  std::string on;   ///< "TEMP"
  std::string how;  ///< "2 % for +10"
};

struct CheckedMaterial {
  std::string name;     ///< as it was asked for
  std::string library;  ///< empty: built in
  std::vector<std::pair<std::string, double>> parameters = {};
  check::Report report = {};
  double wall_s = 0;
  std::string model = {};                           ///< the name of its table
  std::string error = {};                           ///< why it was not checked; empty: it was
  bool unsuitable = false;                          ///< `error`: it is of a kind that is not served
  bool hangs = false;                               ///< it did not come back, or ended what watches it
  std::map<std::string, std::string> replays = {};  ///< of a failed test's id: the file that takes it again

  std::string description = {};  ///< of a foreign model: the YAML file that leads to it

  std::vector<std::string> warnings = {};  ///< sentences on the source or the description, of compiler and program

  std::string printed = {};         ///< by the model, beginning and end
  std::uint64_t printed_bytes = 0;  ///< in all

  std::vector<std::string> of_example = {};  ///< parameters that have the values of the model's own example

  std::vector<Dependence> depends_on = {};  ///< which is no failure, for it may be meant

  std::string unwritten = {};  ///< why a replay file could not be written; empty: all were

  bool passes() const { return error.empty() && report.passes(); }
};

// What is found in a report, and changed in it.

/// The test of that id; null where there is none.
inline auto* test_of(auto& report, const std::string& id) {
  const auto test = std::ranges::find(report.tests, id, &check::TestResult::id);
  return test == report.tests.end() ? nullptr : &*test;
}

/// The test of that id, where it fails; null otherwise.
inline auto* failed_test(auto& report, const std::string& id) {
  auto* const test = test_of(report, id);
  return test && test->verdict == check::Verdict::fail ? test : nullptr;
}

/// The first diagnosis of one of these causes; null where there is none.
inline auto* diagnosed(auto& report, std::initializer_list<const char*> causes) {
  const auto found = std::ranges::find_if(
      report.diagnosis, [&](const check::Diagnosis& each) { return std::ranges::count(causes, each.cause) > 0; });
  return found == report.diagnosis.end() ? nullptr : &*found;
}

int count_of(const check::Report& report, check::Verdict verdict);

inline check::TestResult not_applicable(const std::string& id, const std::string& why) {
  return {.id = id, .verdict = check::Verdict::not_applicable, .sentence = why};
}

/// It fails, which the diagnosis says too.
void fail_test(check::Report& report, check::TestResult& test, const std::string& cause, const std::string& sentence);

/// A test of its own behind the others, and in the diagnosis where it fails.
void add_test(check::Report& report, check::TestResult test);

/// Another sentence, with the test's cause, in the diagnosis too.
void say_instead(check::Report& report, check::TestResult& test, const std::string& sentence);

/// More words behind a sentence, wherever it stands.
void say_also(check::Report& report, const std::string& sentence, const std::string& more);

/// A remark behind the sentence of a test.
void remark(check::TestResult& test, const std::string& words);

// How it is told.

/// What a test that passes has to say all the same, or empty: a remark, or why it passes with a measure above its
/// limit.
std::string remark_of(const check::TestResult& test);

/// Rows of the table of tests: all, or failures and remarks.
enum class Rows { all, telling };

/// The verdict, its causes and the files that show them again; then the table of the tests. Verbosity::verbose: every
/// row with its sentence; quiet: no table.
std::string check_text(const CheckedMaterial& checked, Verbosity verbosity, Rows rows = Rows::all);

/// One line for each, the causes below, and how many passed.
std::string check_text(const std::vector<CheckedMaterial>& all, double wall_s);

/// {material, library, parameters, verdict, wall_s, error, warnings, strain, pressure, step, not_tested, depends_on:
/// [{on, how}], diagnosis: [{cause, sentence}], tests: [{id, verdict, wall_s, measure, threshold, order, cause,
/// sentence, replay}]}; figures that were not found, or are infinite, are null.
std::string check_json(const CheckedMaterial& checked);

/// {verdict, materials: [as above]}.
std::string check_json(const std::vector<CheckedMaterial>& all);

/// What check_json has made; none where it is not whole.
std::optional<CheckedMaterial> checked_of_json(const std::string& text);

/// One test suite for each; the message of a failure is "cause: sentence". A name stands in place of the materials'.
std::string check_junit(const std::vector<CheckedMaterial>& all, const std::string& name = {});

/// Of a whole material: "pass", "fail", "error".
std::string overall(const CheckedMaterial& checked);

/// "pass", "fail", "n/a"; as tables show it: "FAIL".
const char* verdict_name(check::Verdict verdict);
std::string shown_verdict(check::Verdict verdict);

}  // namespace assay::drivers
