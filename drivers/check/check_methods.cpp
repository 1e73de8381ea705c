// SPDX-License-Identifier: BSD-3-Clause
// `assay check --methods`: the patch tests of every particle method that can be composed, in the plane or in space, as
// text, JSON and JUnit.
#include "drivers/check/methods_report.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "adapters/builtin.hpp"
#include "drivers/check/check.hpp"
#include "drivers/check/check_report.hpp"
#include "drivers/result/json_figure.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/system/progress.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/wrapped_text.hpp"
#include "harness/numeric/stopwatch.hpp"

namespace assay::drivers {

namespace {

using Json = nlohmann::ordered_json;
using check::TestResult;
using check::Verdict;

/// To a tenth, as much as two grids tell.
std::string order_text(const std::optional<double>& order) {
  return order ? rounded_text(std::round(10 * *order) / 10 + 0.0, 3) : "-";
}

std::string method_row(const std::string& id, const std::string& verdict, const std::string& measure,
                       const std::string& threshold, const std::string& order) {
  return table_line("  " + padded(id, 25) + padded(verdict, 9) + padded(measure, 11) + padded(threshold, 10) + order);
}

const std::string head_of_tests = method_row("test", "verdict", "measured", "at most", "order");

std::string rows_of(const mpm::MethodReport& report, Verbosity verbosity) {
  std::string page = name_of(report.method) + "\n";
  for (const TestResult& test : report.tests) {
    page += method_row(test.id, shown_verdict(test.verdict), measured_text(test.measure), measured_text(test.threshold),
                       order_text(test.order));
    if (verbosity == Verbosity::verbose || test.verdict == Verdict::fail)
      page += wrapped(test.sentence, "    ", "    ");
  }
  return page;
}

std::int64_t tests_of(const std::vector<mpm::MethodReport>& methods, Verdict verdict) {
  std::int64_t count = 0;
  for (const auto& report : methods) count += std::ranges::count(report.tests, verdict, &TestResult::verdict);
  return count;
}

/// What belongs to that name; a new entry at the end where there is none.
template <class T>
T& entry_under(std::vector<std::pair<std::string, T>>& entries, const std::string& name) {
  const auto known = std::ranges::find(entries, name, &std::pair<std::string, T>::first);
  return known == entries.end() ? entries.emplace_back(name, T()).second : known->second;
}

/// What is not promised and why, each reason once.
std::string reasons(const CheckedMethods& checked) {
  std::vector<std::pair<std::string, std::vector<std::string>>> found;  // reason, ids
  for (const auto& report : checked.methods) {
    for (const TestResult& test : report.tests) {
      const std::string reason = exemption(report.method, test.id);
      if (reason.empty()) continue;
      std::vector<std::string>& ids = entry_under(found, reason);
      if (std::ranges::count(ids, test.id) == 0) ids.push_back(test.id);
    }
  }
  std::string page;
  for (const auto& [reason, ids] : found) page += wrapped(joined(ids) + ": " + reason, "n/a  ", "     ");
  return page;
}

/// "methods: pass; 197 methods, 2380 tests passed, 0 failed, 969 not promised"
std::string verdict_of(const CheckedMethods& checked) {
  const auto& all = checked.methods;
  return std::string(checked.dimension == 3 ? "methods in three dimensions: " : "methods: ") +
         (checked.passes() ? "pass" : "FAIL") + "; " + std::to_string(all.size()) +
         (all.size() == 1 ? " method, " : " methods, ") + tests_passed(tests_of(all, Verdict::pass)) + ", " +
         std::to_string(tests_of(all, Verdict::fail)) + " failed, " +
         std::to_string(tests_of(all, Verdict::not_applicable)) + " not promised\n";
}

/// The rows of what fails, below the method's name.
std::string failures_of(const CheckedMethods& checked) {
  std::string page;
  for (mpm::MethodReport report : checked.methods) {
    std::erase_if(report.tests, [](const TestResult& test) { return test.verdict != Verdict::fail; });
    if (!report.tests.empty()) page += rows_of(report, Verbosity::normal);
  }
  return page.empty() ? page : head_of_tests + page + "\n";
}

/// A line for each basis and formulation, in the order of the methods.
std::string counts_by_basis(const CheckedMethods& checked) {
  std::vector<std::pair<std::string, std::vector<mpm::MethodReport>>> groups;
  for (const mpm::MethodReport& report : checked.methods) {
    const mpm::MethodNames names = names_of(report.method);
    entry_under(groups, names.basis + ", " + names.formulation).push_back(report);
  }
  std::string page = method_row("basis", "methods", "passed", "failed", "not promised");
  for (const auto& [group, reports] : groups) {
    const auto counted = [&of = reports](Verdict verdict) { return std::to_string(tests_of(of, verdict)); };
    page += method_row(group, std::to_string(reports.size()), counted(Verdict::pass), counted(Verdict::fail),
                       counted(Verdict::not_applicable));
  }
  return page;
}

Json json_of(const mpm::Method& method, const TestResult& test) {
  const mpm::MethodNames names = names_of(method);
  return {{"method", name_of(method)},
          {"basis", names.basis},
          {"formulation", names.formulation},
          {"transfer", names.transfer},
          {"update", names.update},
          {"mass", names.mass},
          {"id", test.id},
          {"verdict", verdict_name(test.verdict)},
          {"measure", json_figure(test.measure)},
          {"threshold", json_figure(test.threshold)},
          {"order", json_figure(test.order)},
          {"cause", json_text(test.cause)},
          {"sentence", test.sentence}};
}

/// All that can be composed, or the one of that name.
std::vector<mpm::Method> chosen_methods(const std::string& name) {
  std::vector<mpm::Method> all = mpm::all_methods();
  if (name.empty()) return all;
  std::vector<std::string> names;
  for (const mpm::Method& method : all) {
    if (name_of(method) == name) return {method};
    names.push_back(name_of(method));
  }
  throw InputError(
      {}, "--methods",
      unknown("method '" + one_line(name, 60) + "'", name, names) + "; --methods --verbose prints them all");
}

template <int Dim>
std::vector<mpm::MethodReport> reports_of(const std::vector<mpm::Method>& methods, const CheckOptions& options) {
  const auto material = std::make_shared<const Material>(adapters::builtin_table("neo_hookean"),
                                                         std::map<std::string, double>{{"E", 1e3}, {"nu", 0.3}});
  const mpm::Bench<Dim> bench = mpm::bench_of<Dim>(material, options.quick);
  std::vector<mpm::MethodReport> reports;
  Progress progress("check", options.verbosity == Verbosity::quiet);
  for (const mpm::Method& method : methods) {
    stop_if_interrupted();
    progress.update(static_cast<double>(reports.size()) / static_cast<double>(methods.size()), name_of(method));
    reports.push_back(mpm::run_patch_tests(method, bench));
  }
  progress.finish();
  return reports;
}

}  // namespace

bool CheckedMethods::passes() const {
  return std::ranges::all_of(methods, [](const auto& report) { return report.passes(); });
}

std::string methods_text(const CheckedMethods& checked, Verbosity verbosity) {
  std::string verdict = verdict_of(checked);
  if (verbosity == Verbosity::quiet) return verdict;
  std::string page = verdict + "\n";
  if (verbosity == Verbosity::verbose || checked.methods.size() == 1) {
    page += head_of_tests;
    for (const auto& report : checked.methods) page += rows_of(report, verbosity);
    return page + "\n" + reasons(checked);
  }
  return page + failures_of(checked) + counts_by_basis(checked) + "\n" + reasons(checked) +
         "\n--verbose shows every test, --markdown - which method passes which.\n";
}

std::string methods_json(const CheckedMethods& checked) {
  Json out;
  if (checked.dimension == 3) out["dimension"] = 3;
  out["methods"] = Json::array();
  for (const auto& report : checked.methods) out["methods"].push_back(name_of(report.method));
  out["verdict"] = checked.passes() ? "pass" : "fail";
  out["tests"] = Json::array();
  for (const auto& report : checked.methods) {
    for (const TestResult& test : report.tests) out["tests"].push_back(json_of(report.method, test));
  }
  return json_document(out);
}

std::string methods_junit(const CheckedMethods& checked, const std::string& name) {
  CheckedMaterial all;
  all.name = checked.dimension == 3 ? "methods_3d" : "methods";
  all.wall_s = checked.wall_s;
  for (const auto& report : checked.methods) {
    for (TestResult test : report.tests) {
      test.id = name_of(report.method) + " " + test.id;
      all.report.tests.push_back(std::move(test));
    }
  }
  return check_junit({all}, name);
}

int check_methods(const CheckOptions& options) {
  watch_interrupts();
  const Stopwatch watch;
  CheckedMethods checked;
  checked.dimension = options.dimension;
  const std::vector<mpm::Method> methods = chosen_methods(options.material);
  checked.methods = options.dimension == 3 ? reports_of<3>(methods, options) : reports_of<2>(methods, options);
  checked.wall_s = watch.seconds();
  stop_if_interrupted();
  tell_check(options, methods_text(checked, options.verbosity), methods_json(checked),
             methods_junit(checked, options.junit_name), methods_markdown(checked));
  return checked.passes() ? 0 : 1;
}

}  // namespace assay::drivers
