// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/check_report.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <nlohmann/json.hpp>

#include "drivers/material/material_path.hpp"
#include "drivers/output/number_format.hpp"
#include "drivers/output/numbers.hpp"
#include "drivers/output/table_text.hpp"
#include "drivers/picture/drawing.hpp"

namespace assay::drivers {

namespace {

using Json = nlohmann::ordered_json;
using check::TestResult;
using check::Verdict;

Json number(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

std::string attribute(const char* name, const std::string& value) {
  return std::string(" ") + name + "=\"" + escaped(value) + "\"";
}

Json json_of(const CheckedMaterial& checked) {
  Json out;
  out["material"] = checked.name;
  out["library"] = checked.library.empty() ? Json(nullptr) : Json(checked.library);
  if (!checked.description.empty()) out["description"] = checked.description;
  out["model"] = checked.model.empty() ? Json(nullptr) : Json(checked.model);
  out["parameters"] = Json::object();
  for (const auto& [name, value] : checked.parameters) out["parameters"][name] = number(value);
  if (!checked.of_example.empty()) out["parameters_of_example"] = checked.of_example;
  out["verdict"] = overall(checked);
  out["error"] = checked.error.empty() ? Json(nullptr) : Json(checked.error);
  out["unwritten"] = checked.unwritten.empty() ? Json(nullptr) : Json(checked.unwritten);
  out["printed"] = checked.printed;
  out["wall_s"] = number(checked.wall_s);
  out["strain"] = number(checked.report.strain);
  out["pressure"] = number(checked.report.pressure);
  out["diagnosis"] = Json::array();
  for (const check::Diagnosis& d : checked.report.diagnosis) {
    out["diagnosis"].push_back({{"cause", d.cause}, {"sentence", d.sentence}});
  }
  out["tests"] = Json::array();
  for (const TestResult& test : checked.report.tests) {
    const auto replay = checked.replays.find(test.id);
    out["tests"].push_back({{"id", test.id},
                            {"verdict", verdict_name(test.verdict)},
                            {"measure", number(test.measure)},
                            {"threshold", number(test.threshold)},
                            {"order", number(test.order)},
                            {"cause", test.cause.empty() ? Json(nullptr) : Json(test.cause)},
                            {"sentence", test.sentence},
                            {"replay", replay == checked.replays.end() ? Json(nullptr) : Json(replay->second)}});
  }
  return out;
}

std::string written(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

std::string text_in(const Json& value) { return value.is_null() ? std::string() : value.get<std::string>(); }

std::optional<double> number_in(const Json& value) {
  return value.is_null() ? std::nullopt : std::optional(value.get<double>());
}

TestResult test_in(const Json& test) {
  const std::string verdict = test.at("verdict");
  const bool measured = !test.at("measure").is_null();
  const bool infinite = !measured && verdict == "fail" && !test.at("threshold").is_null();
  return {.id = test.at("id"),
          .verdict = verdict == "pass"   ? Verdict::pass
                     : verdict == "fail" ? Verdict::fail
                                         : Verdict::not_applicable,
          .measure = infinite ? std::optional<double>(INFINITY) : number_in(test.at("measure")),
          .threshold = number_in(test.at("threshold")),
          .order = number_in(test.at("order")),
          .cause = text_in(test.at("cause")),
          .sentence = test.at("sentence")};
}

}  // namespace

std::string check_json(const CheckedMaterial& checked) { return written(json_of(checked)); }

std::string check_json(const std::vector<CheckedMaterial>& all) {
  Json out;
  const auto any = [&](const char* verdict) {
    return std::any_of(all.begin(), all.end(), [&](const auto& checked) { return overall(checked) == verdict; });
  };
  out["verdict"] = any("fail") ? "fail" : any("error") ? "error" : "pass";
  out["materials"] = Json::array();
  for (const CheckedMaterial& checked : all) out["materials"].push_back(json_of(checked));
  return written(out);
}

namespace {

/// Throws Json::exception where something is missing, or not what it should be.
CheckedMaterial checked_in(const Json& found) {
  CheckedMaterial checked;
  checked.name = found.at("material");
  checked.library = text_in(found.at("library"));
  checked.description = found.contains("description") ? text_in(found.at("description")) : std::string();
  for (const auto& [name, value] : found.at("parameters").items()) {
    checked.parameters.emplace_back(name, number_in(value).value_or(NAN));
  }
  if (const auto names = found.find("parameters_of_example"); names != found.end()) {
    checked.of_example = names->get<std::vector<std::string>>();
  }
  checked.model = text_in(found.at("model"));
  checked.error = text_in(found.at("error"));
  checked.unwritten = text_in(found.at("unwritten"));
  checked.wall_s = number_in(found.at("wall_s")).value_or(0);
  checked.report.strain = number_in(found.at("strain")).value_or(0);
  checked.report.pressure = number_in(found.at("pressure")).value_or(0);
  for (const Json& d : found.at("diagnosis")) checked.report.diagnosis.push_back({d.at("cause"), d.at("sentence")});
  for (const Json& test : found.at("tests")) {
    checked.report.tests.push_back(test_in(test));
    if (!test.at("replay").is_null()) checked.replays[test.at("id")] = test.at("replay");
  }
  return checked;
}

}  // namespace

std::optional<CheckedMaterial> checked_of_json(const std::string& text) {
  const Json found = Json::parse(text, nullptr, false);
  if (found.is_discarded()) return std::nullopt;
  try {
    return checked_in(found);
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

namespace {

/// [s], as a decimal: schemas know no exponents.
std::string decimal(double seconds) {
  char text[64];
  std::snprintf(text, sizeof text, "%.3f", seconds);
  return text;
}

/// "2026-11-20T22:38:27", UTC.
std::string timestamp() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  char text[32];
  gmtime_r(&now, &utc);
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%S", &utc);
  return text;
}

/// "E, nu"
std::string joined(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

/// The same wherever the library lies.
std::string class_of(const CheckedMaterial& checked) {
  return "assay.check." + (is_material_name(checked.name) || checked.model.empty() ? checked.name : checked.model);
}

std::string test_case(const CheckedMaterial& checked, const TestResult& test) {
  const std::string head =
      "    <testcase" + attribute("classname", class_of(checked)) + attribute("name", test.id) + attribute("time", "0");
  if (test.verdict == Verdict::pass) return head + "/>\n";
  if (test.verdict == Verdict::not_applicable) {
    return head + ">\n      <skipped" + attribute("message", test.sentence) + "/>\n    </testcase>\n";
  }
  const auto replay = checked.replays.find(test.id);
  return head + ">\n      <failure" + attribute("message", test.cause + ": " + test.sentence) +
         attribute("type", test.cause) + ">" +
         escaped("measured " + measured_text(test.measure) + ", at most " + measured_text(test.threshold) +
                 (replay == checked.replays.end() ? "" : "; again: assay check --replay " + replay->second)) +
         "</failure>\n    </testcase>\n";
}

std::string error_case(const CheckedMaterial& checked) {
  return "    <testcase" + attribute("classname", class_of(checked)) + attribute("name", "loading") +
         attribute("time", "0") + ">\n      <error" + attribute("message", checked.error) +
         attribute("type", "not checked") + "/>\n    </testcase>\n";
}

/// In the order and with the attributes that Ant's schema and that of Jenkins ask for.
std::string suite(const CheckedMaterial& checked, std::size_t id) {
  const check::Report& report = checked.report;
  const bool broken = !checked.error.empty();
  std::string page =
      "  <testsuite" + attribute("name", "assay check " + checked.name) + attribute("package", "assay.check") +
      attribute("id", std::to_string(id)) + attribute("timestamp", timestamp()) + attribute("hostname", "localhost") +
      attribute("tests", std::to_string(report.tests.size() + (broken ? 1 : 0))) +
      attribute("failures", std::to_string(count_of(report, Verdict::fail))) + attribute("errors", broken ? "1" : "0") +
      attribute("skipped", std::to_string(count_of(report, Verdict::not_applicable))) +
      attribute("time", decimal(checked.wall_s)) + ">\n    <properties>\n";
  for (const auto& [name, value] : checked.parameters) {
    page += "      <property" + attribute("name", name) + attribute("value", number_text(value)) + "/>\n";
  }
  if (!checked.of_example.empty()) {
    page += "      <property" + attribute("name", "parameters of the example") +
            attribute("value", joined(checked.of_example)) + "/>\n";
  }
  page += "    </properties>\n";
  for (const TestResult& test : report.tests) page += test_case(checked, test);
  if (broken) page += error_case(checked);
  std::string told;
  for (const check::Diagnosis& d : report.diagnosis) told += d.cause + ": " + d.sentence + "\n";
  return page + "    <system-out>" + escaped(told) + "</system-out>\n    <system-err/>\n  </testsuite>\n";
}

}  // namespace

std::string check_junit(const std::vector<CheckedMaterial>& all) {
  std::string page = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n";
  for (std::size_t id = 0; id < all.size(); ++id) page += suite(all[id], id);
  return page + "</testsuites>\n";
}

}  // namespace assay::drivers
