// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/study_json.hpp"

#include <nlohmann/json.hpp>

#include "drivers/output/json_figure.hpp"
#include "drivers/study/clock.hpp"

namespace assay::drivers {

namespace {

using Json = nlohmann::ordered_json;

Json index_json(const std::optional<std::size_t>& index) { return index ? Json(*index) : Json(nullptr); }

template <class List, class Convert>
Json list_json(const List& list, const Convert& convert) {
  Json out = Json::array();
  for (const auto& each : list) out.push_back(convert(each));
  return out;
}

Json numbers_json(const std::vector<double>& list) {
  return list_json(list, [](double each) { return json_figure(each); });
}

Json leaf_json(const FlatValue& value) {
  if (const double* number = std::get_if<double>(&value)) return json_figure(*number);
  if (const std::string* text = std::get_if<std::string>(&value)) return *text;
  if (const bool* flag = std::get_if<bool>(&value)) return *flag;
  return nullptr;
}

Json clock_json(const ClockReadings& clock) {
  Json out;
  out["alone"] = clock.alone;
  out["step_s"] = numbers_json(clock.step_s);
  out["cpu_s"] = numbers_json(clock.cpu_s);
  out["wall_s"] = numbers_json(clock.wall_s);
  out["others"] = numbers_json(clock.others);
  out["machine"] = clock.machine;
  return out;
}

Json pass_json(const PassFigures& pass) {
  return Json::object({{"name", pass.name},
                       {"seconds", json_figure(pass.seconds)},
                       {"bytes_per_particle", json_figure(pass.bytes_per_particle)}});
}

Json case_json(const StudyCase& one) {
  Json out;
  out["number"] = one.number;
  out["key"] = one.key;
  out["values"] = list_json(one.values, [](const AxisValue& at) {
    return Json::object({{"axis", at.axis}, {"value", at.value}});
  });
  out["label"] = one.label;
  out["series"] = one.series;
  out["resolution"] = json_figure(one.resolution);
  out["outcome"] = one.outcome;
  out["reason"] = one.reason;
  out["budget"] = one.budget;
  out["error"] = json_figure(one.error);
  out["cost"] = json_figure(one.cost);
  out["cost_spread"] = json_figure(one.cost_spread);
  out["work"] = json_figure(one.work);
  out["eligible"] = one.eligible;
  out["on_front"] = one.on_front;
  out["clock"] = clock_json(one.clock);
  out["figures"] = Json::object();
  for (const auto& [key, value] : one.figures) out["figures"][key] = leaf_json(value);
  out["passes"] = list_json(one.passes, pass_json);
  out["history"] = list_json(one.history, [](const std::array<double, 2>& at) {
    return Json::array({json_figure(at[0]), json_figure(at[1])});
  });
  return out;
}

Json fit_json(const std::optional<FittedOrder>& fit) {
  if (!fit) return nullptr;
  return Json::object(
      {{"order", json_figure(fit->order)}, {"lower", json_figure(fit->lower)}, {"upper", json_figure(fit->upper)}});
}

Json series_json(const StudySeries& series) {
  using Range = StudySeries::Range;
  Json out;
  out["name"] = series.name;
  out["cases"] = series.cases;
  out["pairwise"] = list_json(series.pairwise, json_figure);
  out["fit"] = fit_json(series.fit);
  out["asymptotic"] = series.asymptotic == Range::reached       ? "reached"
                      : series.asymptotic == Range::not_reached ? "not_reached"
                                                                : "unknown";
  out["sentence"] = series.sentence;
  out["published"] = json_figure(series.published);
  out["source"] = series.source;
  return out;
}

Json digit_json(const StudyDigit& digit) {
  Json out;
  out["error"] = json_figure(digit.error);
  out["best"] = index_json(digit.best);
  out["cost"] = json_figure(digit.cost);
  out["series"] = digit.series;
  out["interpolated"] = json_figure(digit.interpolated);
  out["factor"] = json_figure(digit.factor);
  return out;
}

Json budget_json(const BudgetLine& line) {
  Json out;
  out["base"] = line.base;
  out["source"] = line.source;
  out["changed"] = line.changed;
  out["error"] = json_figure(line.error);
  out["refined"] = json_figure(line.refined);
  out["share"] = json_figure(line.share);
  out["outcome"] = line.outcome;
  return out;
}

Json expectation_json(const StudyExpectationOutcome& line) {
  return Json::object({{"where", line.where},
                       {"key", line.outcome.key},
                       {"expected", line.outcome.expected},
                       {"found", line.outcome.found},
                       {"holds", line.outcome.holds}});
}

Json origin_json(const Provenance& from) {
  Json out;
  out["version"] = from.version;
  out["git"] = from.git;
  out["compiler"] = from.compiler;
  out["flags"] = from.flags;
  out["material"] = from.material;
  out["libraries"] = from.libraries;
  out["scene_sha256"] = from.scene_sha256;
  return out;
}

Json quantity_json(const std::string& key, const std::string& name, const std::string& unit) {
  return Json::object({{"key", key}, {"name", name}, {"unit", unit}});
}

}  // namespace

nlohmann::ordered_json load_json(const StudyFindings& findings) {
  const MeasuredLoad load = load_of(findings);
  return Json::object({{"share", load.timed > 0 ? json_figure(load.share) : Json(nullptr)},
                       {"timed", load.timed},
                       {"disturbed", load.disturbed},
                       {"noticeable", load.noticeable()}});
}

std::string study_json(const StudyFindings& findings) {
  Json out;
  out["format"] = study_format;
  out["version"] = study_version;
  out["title"] = findings.title;
  out["question"] = findings.question;
  out["answer"] = findings.asks_survival ? "survival" : "cost";
  out["error"] = quantity_json(findings.error_key, findings.error_name, findings.error_unit);
  out["cost"] = quantity_json(findings.cost_key, findings.cost_name, findings.cost_unit);
  out["refine"] = findings.refine_key;
  out["axes"] = findings.axes;
  out["cases"] = list_json(findings.cases, case_json);
  out["series"] = list_json(findings.series, series_json);
  out["front"] = findings.front;
  out["work_front"] = findings.work_front;
  out["digits"] = list_json(findings.digits, digit_json);
  out["budget"] = list_json(findings.budget, budget_json);
  out["expect"] = list_json(findings.expect, expectation_json);
  out["warnings"] = findings.warnings;
  out["machines"] = findings.machines;
  out["load"] = load_json(findings);
  out["provenance"] = origin_json(findings.provenance);
  out["study"] = findings.study_yaml;
  return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace assay::drivers
