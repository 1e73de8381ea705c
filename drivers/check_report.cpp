// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/check_report.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "drivers/output/number_format.hpp"
#include "drivers/output/wrapped_text.hpp"
#include "drivers/picture/drawing.hpp"

namespace assay::drivers {

namespace {

using Json = nlohmann::ordered_json;
using check::TestResult;
using check::Verdict;

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(text.size(), width), ' ');
  return text;
}

std::string figure(const std::optional<double>& value) {
  if (!value) return "-";
  return std::isinf(*value) ? "infinite" : rounded_text(*value, 2);
}

std::string row(const std::string& id, const std::string& verdict, const std::string& measure,
                const std::string& threshold, const std::string& order) {
  std::string line = padded(id, 26) + padded(verdict, 9) + padded(measure, 11) + padded(threshold, 11) + order;
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

int count_of(const check::Report& report, Verdict verdict) {
  return static_cast<int>(std::count_if(report.tests.begin(), report.tests.end(),
                                        [&](const TestResult& test) { return test.verdict == verdict; }));
}

std::string summary(const CheckedMaterial& checked) {
  const check::Report& report = checked.report;
  return checked.name + ": " + (report.passes() ? "pass" : "FAIL") + "; " +
         std::to_string(count_of(report, Verdict::pass)) + " tests passed, " +
         std::to_string(count_of(report, Verdict::fail)) + " failed, " +
         std::to_string(count_of(report, Verdict::not_applicable)) + " not applicable, in " +
         rounded_text(checked.wall_s, 2) + " s\n";
}

Json number(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

std::string attribute(const char* name, const std::string& value) {
  return std::string(" ") + name + "=\"" + escaped(value) + "\"";
}

std::string test_case(const CheckedMaterial& checked, const TestResult& test) {
  const std::string head = "    <testcase" + attribute("classname", "assay.check." + checked.name) +
                           attribute("name", test.id) + attribute("time", "0");
  if (test.verdict == Verdict::pass) return head + "/>\n";
  if (test.verdict == Verdict::not_applicable) {
    return head + ">\n      <skipped" + attribute("message", test.sentence) + "/>\n    </testcase>\n";
  }
  return head + ">\n      <failure" + attribute("message", test.cause + ": " + test.sentence) +
         attribute("type", test.cause) + ">" +
         escaped("measured " + figure(test.measure) + ", at most " + figure(test.threshold)) +
         "</failure>\n    </testcase>\n";
}

}  // namespace

const char* verdict_name(Verdict verdict) {
  return verdict == Verdict::pass ? "pass" : verdict == Verdict::fail ? "fail" : "n/a";
}

std::string check_text(const CheckedMaterial& checked, Verbosity verbosity) {
  std::string page;
  if (verbosity != Verbosity::quiet) {
    page += row("test", "verdict", "measured", "at most", "order");
    for (const TestResult& test : checked.report.tests) {
      page += row(test.id, test.verdict == Verdict::fail ? "FAIL" : verdict_name(test.verdict), figure(test.measure),
                  figure(test.threshold), figure(test.order));
      if (verbosity == Verbosity::verbose || test.verdict == Verdict::fail)
        page += wrapped(test.sentence, "    ", "    ");
    }
    page += "\n";
  }
  page += summary(checked);
  for (const check::Diagnosis& d : checked.report.diagnosis) {
    page += wrapped(d.cause, "diagnosis: ", "");
    page += wrapped(d.sentence, "    ", "    ");
  }
  return page;
}

std::string check_json(const CheckedMaterial& checked) {
  Json out;
  out["material"] = checked.name;
  out["library"] = checked.library.empty() ? Json(nullptr) : Json(checked.library);
  out["parameters"] = Json::object();
  for (const auto& [name, value] : checked.parameters) out["parameters"][name] = number(value);
  out["verdict"] = checked.report.passes() ? "pass" : "fail";
  out["diagnosis"] = Json::array();
  for (const check::Diagnosis& d : checked.report.diagnosis) {
    out["diagnosis"].push_back({{"cause", d.cause}, {"sentence", d.sentence}});
  }
  out["tests"] = Json::array();
  for (const TestResult& test : checked.report.tests) {
    out["tests"].push_back({{"id", test.id},
                            {"verdict", verdict_name(test.verdict)},
                            {"measure", number(test.measure)},
                            {"threshold", number(test.threshold)},
                            {"order", number(test.order)},
                            {"cause", test.cause.empty() ? Json(nullptr) : Json(test.cause)},
                            {"sentence", test.sentence}});
  }
  return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string check_junit(const CheckedMaterial& checked) {
  const check::Report& report = checked.report;
  const std::string counts = attribute("tests", std::to_string(report.tests.size())) +
                             attribute("failures", std::to_string(count_of(report, Verdict::fail))) +
                             attribute("errors", "0");
  const std::string skipped = attribute("skipped", std::to_string(count_of(report, Verdict::not_applicable)));
  const std::string time = attribute("time", rounded_text(checked.wall_s, 3));
  std::string page = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites" + counts + time + ">\n";
  page += "  <testsuite" + attribute("name", "assay check " + checked.name) + counts + skipped + time + ">\n";
  for (const TestResult& test : report.tests) page += test_case(checked, test);
  return page + "  </testsuite>\n</testsuites>\n";
}

}  // namespace assay::drivers
