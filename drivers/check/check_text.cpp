// SPDX-License-Identifier: BSD-3-Clause
// What the battery has found, as text of 80 columns.
#include <algorithm>

#include "drivers/check/check_report.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/wrapped_text.hpp"

namespace assay::drivers {

using check::TestResult;
using check::Verdict;

std::string remark_of(const TestResult& test) {
  if (test.verdict != Verdict::pass) return {};
  if (test.measure && test.threshold && *test.measure > *test.threshold) return test.sentence;  // passes otherwise
  const std::size_t at = test.sentence.find(check::remark_words);
  return at == std::string::npos ? "" : test.sentence.substr(at);
}

int count_of(const check::Report& report, Verdict verdict) {
  return static_cast<int>(std::ranges::count(report.tests, verdict, &TestResult::verdict));
}

const char* verdict_name(Verdict verdict) {
  return verdict == Verdict::pass ? "pass" : verdict == Verdict::fail ? "fail" : "n/a";
}

std::string shown_verdict(Verdict verdict) { return verdict == Verdict::fail ? "FAIL" : verdict_name(verdict); }

std::string overall(const CheckedMaterial& checked) {
  return !checked.error.empty() ? "error" : checked.report.passes() ? "pass" : "fail";
}

namespace {

std::string row(const std::string& id, const std::string& verdict, const std::string& measure,
                const std::string& threshold, const std::string& order) {
  return table_line(padded(id + " ", 26) + padded(verdict, 9) + padded(measure, 11) + padded(threshold, 11) + order);
}

/// "; strains to 0.019, under 1e+05 Pa": where they are not those of most models.
std::string unusual_effort(const check::Report& report) {
  std::string text;
  if (report.strain > 0 && report.strain < 0.5 * check::Effort{}.strain)
    text += "; strains to " + rounded_text(report.strain, 2);
  if (report.pressure > 0)
    text += (text.empty() ? "; under " : ", under ") + rounded_text(report.pressure, 2) + " Pa at rest";
  return text;
}

/// "c10 = 120, c01 = 40": what was not given.
std::string example_values(const CheckedMaterial& checked) {
  std::vector<std::string> values;
  for (const auto& [name, value] : checked.parameters) {
    if (std::ranges::count(checked.of_example, name) > 0) values.push_back(name + " = " + rounded_text(value, 6));
  }
  return joined(values);
}

/// "depends on TEMP (2 % for +10), COORDS (...)"
std::string dependences(const CheckedMaterial& checked) {
  const auto words = [](const Dependence& each) { return each.on + " (" + each.how + ")"; };
  return "depends on " + joined(checked.depends_on, words);
}

/// "; 2 remarks": tests that pass and have something to say all the same.
std::string remarks_text(const check::Report& report) {
  const auto count =
      std::ranges::count_if(report.tests, [](const TestResult& test) { return !remark_of(test).empty(); });
  return count == 0 ? "" : "; " + std::to_string(count) + (count == 1 ? " remark" : " remarks");
}

/// "; 1 warning": of the source or the description, whatever the verdict.
std::string warnings_text(const CheckedMaterial& checked) {
  const std::size_t count = checked.warnings.size();
  return count == 0 ? "" : "; " + std::to_string(count) + (count == 1 ? " warning" : " warnings");
}

std::string summary(const CheckedMaterial& checked) {
  const check::Report& report = checked.report;
  return one_line(checked.name) + ": " + (report.passes() ? "pass" : "FAIL") + "; " +
         tests_passed(count_of(report, Verdict::pass)) + ", " + std::to_string(count_of(report, Verdict::fail)) +
         " failed, " + std::to_string(count_of(report, Verdict::not_applicable)) + " not applicable, in " +
         rounded_text(checked.wall_s, 2) + " s" + remarks_text(report) + warnings_text(checked) +
         unusual_effort(report) + (checked.depends_on.empty() ? "" : "; " + dependences(checked));
}

/// What is printed below a test's row: its sentence where the row alone would not explain the verdict.
std::string words_of(const TestResult& test, Verbosity verbosity) {
  const bool whole = verbosity == Verbosity::verbose || test.verdict == Verdict::fail;
  return whole ? test.sentence : remark_of(test);
}

/// The tests as a table, below a blank line; empty where no row is wanted.
std::string table_of(const CheckedMaterial& checked, Verbosity verbosity, Rows rows) {
  std::string page;
  std::size_t left = 0, shown = 0;
  for (const TestResult& test : checked.report.tests) {
    const std::string words = words_of(test, verbosity);
    const bool not_judged = test.sentence.starts_with(check::not_judged);
    if (verbosity != Verbosity::verbose && (not_judged || (rows == Rows::telling && words.empty()))) {
      ++left;
      continue;
    }
    ++shown;
    page += row(test.id, shown_verdict(test.verdict), measured_text(test.measure), measured_text(test.threshold),
                measured_text(test.order));
    if (!words.empty()) page += wrapped(words, "    ", "    ");
  }
  if (shown > 0) page.insert(0, "\n" + row("test", "verdict", "measured", "at most", "order"));
  if (left == 0) return page;
  const std::string others = "(" + std::to_string(left) + (left == 1 ? " other" : " others");
  return page + (rows == Rows::telling ? others + ": --verbose)\n" : row(others + ")", "n/a", "-", "-", "-"));
}

}  // namespace

std::string check_text(const CheckedMaterial& checked, Verbosity verbosity, Rows rows) {
  std::string page = wrapped(summary(checked), "", "    ");
  for (const check::Diagnosis& d : checked.report.diagnosis) {
    page += wrapped(d.cause, "diagnosis: ", "");
    page += wrapped(d.sentence, "    ", "    ");
    page += "    more: assay check --explain \"" + d.cause + "\"\n";
  }
  for (const auto& [test, file] : checked.replays) page += "replay: " + one_line(file) + "\n";
  if (checked.passes() && !checked.report.not_tested.empty()) {
    std::string all;
    for (const std::string& what : checked.report.not_tested) all += (all.empty() ? "" : "; ") + what;
    page += wrapped(all, "not tested: ", "    ");
  }
  if (!checked.of_example.empty()) {
    page +=
        wrapped(example_values(checked), "required parameters that were not given, from the model's example: ", "    ");
  }
  if (verbosity != Verbosity::quiet) page += table_of(checked, verbosity, rows);
  if (verbosity == Verbosity::verbose && !checked.printed.empty()) page += "the model printed:\n" + checked.printed;
  return page;
}

std::string check_text(const std::vector<CheckedMaterial>& all, double wall_s) {
  std::string page = row("material", "verdict", "passed", "failed", "n/a");
  std::size_t passed = 0;
  for (const CheckedMaterial& checked : all) {
    const check::Report& report = checked.report;
    passed += checked.passes() ? 1 : 0;
    page += row(one_line(checked.name), overall(checked) == "fail" ? "FAIL" : overall(checked),
                std::to_string(count_of(report, Verdict::pass)), std::to_string(count_of(report, Verdict::fail)),
                std::to_string(count_of(report, Verdict::not_applicable)));
    if (!checked.error.empty()) page += wrapped(checked.error, "    ", "    ");
    for (const check::Diagnosis& d : report.diagnosis) page += wrapped(d.cause + ": " + d.sentence, "    ", "      ");
    if (!checked.depends_on.empty()) page += wrapped(dependences(checked), "    ", "      ");
    for (const std::string& warning : checked.warnings) page += wrapped("warning: " + warning, "    ", "      ");
    for (const auto& [test, file] : checked.replays) page += "    replay: " + one_line(file) + "\n";
  }
  return page + "\n" + std::to_string(passed) + " of " + std::to_string(all.size()) + " materials pass, in " +
         rounded_text(wall_s, 2) + " s\n";
}

}  // namespace assay::drivers
