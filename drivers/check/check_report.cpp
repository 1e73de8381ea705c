// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/check/check_report.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "drivers/output/junit.hpp"
#include "drivers/result/json_figure.hpp"
#include "drivers/scene/material_path.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/text/number_format.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/table_text.hpp"

namespace assay::drivers {

namespace {

using Json = nlohmann::ordered_json;
using check::TestResult;
using check::Verdict;

Json json_of(const CheckedMaterial& checked) {
  Json out;
  out["material"] = checked.name;
  out["library"] = json_text(checked.library);
  if (!checked.description.empty()) out["description"] = checked.description;
  out["model"] = json_text(checked.model);
  out["parameters"] = Json::object();
  for (const auto& [name, value] : checked.parameters) out["parameters"][name] = json_figure(value);
  if (!checked.of_example.empty()) out["parameters_of_example"] = checked.of_example;
  out["verdict"] = overall(checked);
  out["error"] = json_text(checked.error);
  out["unwritten"] = json_text(checked.unwritten);
  out["printed"] = checked.printed;
  out["wall_s"] = json_figure(checked.wall_s);
  out["strain"] = json_figure(checked.report.strain);
  out["pressure"] = json_figure(checked.report.pressure);
  out["step"] = json_figure(checked.report.effort.step);
  out["not_tested"] = checked.report.not_tested;
  if (!checked.depends_on.empty()) out["depends_on"] = Json::array();
  for (const Dependence& each : checked.depends_on) out["depends_on"].push_back({{"on", each.on}, {"how", each.how}});
  out["diagnosis"] = Json::array();
  for (const check::Diagnosis& d : checked.report.diagnosis) {
    out["diagnosis"].push_back({{"cause", d.cause}, {"sentence", d.sentence}});
  }
  out["tests"] = Json::array();
  for (const TestResult& test : checked.report.tests) {
    const auto replay = checked.replays.find(test.id);
    out["tests"].push_back({{"id", test.id},
                            {"verdict", verdict_name(test.verdict)},
                            {"wall_s", json_figure(test.wall_s)},
                            {"measure", json_figure(test.measure)},
                            {"threshold", json_figure(test.threshold)},
                            {"order", json_figure(test.order)},
                            {"cause", json_text(test.cause)},
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
          .sentence = test.at("sentence"),
          .wall_s = test.at("wall_s")};
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
  checked.report.effort.step = number_in(found.at("step")).value_or(1);
  checked.report.not_tested = found.at("not_tested").get<std::vector<std::string>>();
  if (const auto all = found.find("depends_on"); all != found.end()) {
    for (const Json& each : *all) checked.depends_on.push_back({each.at("on"), each.at("how")});
  }
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

/// The same wherever the library lies.
std::string class_of(const CheckedMaterial& checked) {
  return "assay.check." + (is_material_name(checked.name) || checked.model.empty() ? checked.name : checked.model);
}

JunitCase test_case(const CheckedMaterial& checked, const TestResult& test, const std::string& classname) {
  JunitCase out{classname, test.id, test.wall_s};
  if (test.verdict == Verdict::pass) return out;
  if (test.verdict == Verdict::not_applicable) {
    out.kind = JunitCase::Kind::skipped;
    out.message = test.sentence;
    return out;
  }
  const auto replay = checked.replays.find(test.id);
  out.kind = JunitCase::Kind::failure;
  out.message = test.cause + ": " + test.sentence;
  out.type = test.cause;
  out.text = "measured " + measured_text(test.measure) + ", at most " + measured_text(test.threshold) +
             (replay == checked.replays.end() ? "" : "; again: assay check --replay " + replay->second);
  return out;
}

JunitSuite suite(const CheckedMaterial& checked, const std::string& given) {
  const std::string classname = given.empty() ? class_of(checked) : "assay.check." + given;
  JunitSuite out{"assay check " + (given.empty() ? checked.name : given), "assay.check"};
  out.seconds = checked.wall_s;
  for (const auto& [name, value] : checked.parameters) out.properties.emplace_back(name, number_text(value));
  if (!checked.of_example.empty()) {
    out.properties.emplace_back("parameters of the example", joined(checked.of_example));
  }
  for (const std::string& what : checked.report.not_tested) out.properties.emplace_back("not tested", what);
  for (const Dependence& each : checked.depends_on) out.properties.emplace_back("depends on " + each.on, each.how);
  for (const TestResult& test : checked.report.tests) {
    out.cases.push_back(test_case(checked, test, classname));
    if (const std::string remark = remark_of(test); !remark.empty())
      out.properties.emplace_back("remark of " + test.id, remark);
  }
  if (!checked.error.empty()) {
    out.cases.push_back({classname, "loading", 0, JunitCase::Kind::error, checked.error, "not checked"});
  }
  for (const check::Diagnosis& d : checked.report.diagnosis) out.said += d.cause + ": " + d.sentence + "\n";
  return out;
}

}  // namespace

std::string check_junit(const std::vector<CheckedMaterial>& all, const std::string& name) {
  std::vector<JunitSuite> suites;
  for (const CheckedMaterial& checked : all) suites.push_back(suite(checked, name));
  return junit_text(suites);
}

}  // namespace assay::drivers
