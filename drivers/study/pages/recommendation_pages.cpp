// SPDX-License-Identifier: BSD-3-Clause
// What `assay recommend` says.
#include <filesystem>
#include <nlohmann/json.hpp>

#include "drivers/format/yaml_reader.hpp"
#include "drivers/result/json_fields.hpp"
#include "drivers/result/json_figure.hpp"
#include "drivers/study/analysis/clock.hpp"
#include "drivers/study/analysis/study_json.hpp"
#include "drivers/study/pages/study_pages.hpp"
#include "drivers/study/pages/words.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/wrapped_text.hpp"

namespace assay::drivers {

namespace {

using Json = nlohmann::ordered_json;

std::string with_unit(double value, const std::string& unit) {
  return rounded_text(value, 3) + (unit.empty() ? "" : " " + unit);
}

std::string cost_with_spread(const StudyFindings& findings, const StudyCase& one) {
  const std::string text = with_unit(*one.cost, findings.cost_unit);
  if (one.cost_spread) return text + " (+- " + rounded_text(100 * *one.cost_spread, 2) + " %)";
  return is_time(findings) ? text + " (one run: no spread)" : text;
}

/// The axis `threads`, or what the case's figures say.
std::optional<std::int64_t> threads_of(const StudyCase& one) {
  if (const std::string given = value_on(one, "threads"); !given.empty()) return parse_integer(given);
  const Figure threads = number_of(one, "threads");
  if (threads && *threads >= 1 && *threads <= 4096) return static_cast<std::int64_t>(*threads);
  return std::nullopt;
}

/// case.yaml holds all that the axes have set.
std::string command_of(const StoredStudy& study, const StudyCase& one) {
  const std::string folder = study.case_folder(one);
  if (folder.empty()) return {};
  const auto threads = threads_of(one);
  return "assay run " + shell_word((std::filesystem::path(folder) / "case.yaml").string()) +
         (threads ? " --threads " + std::to_string(*threads) : "");
}

/// What is taken, what it costs, and how it is run.
std::string case_lines(const StoredStudy& study, const StudyCase& one, const std::string& first) {
  const StudyFindings& findings = study.findings;
  const auto threads = threads_of(one);
  const std::string command = command_of(study, one),
                    of_threads = threads ? std::to_string(*threads) + (*threads == 1 ? " thread" : " threads")
                                         : "threads not recorded";
  return wrapped(one.label, first, "  ") +
         wrapped("error " + error_text(findings, *one.error) + ", cost " + cost_with_spread(findings, one) + ", " +
                     of_threads,
                 "  ", "    ") +
         (command.empty() ? "" : "  " + command + "\n");
}

std::string next_text(const StudyFindings& findings, const std::optional<NextDigit>& next) {
  if (!next) return "next digit: the study has no finer level\n";
  const std::string factor = next->factor ? ", " + rounded_text(*next->factor, 3) + " times the cost" : "";
  std::string between, text;
  if (next->interpolated) between = with_unit(*next->interpolated, findings.cost_unit) + " between resolutions";
  if (next->best && findings.cases[*next->best].cost) {
    const StudyCase& one = findings.cases[*next->best];
    text = one.label + ", " + cost_with_spread(findings, one) + factor + (between.empty() ? "" : "; " + between);
  } else {
    text = between.empty() ? "no measured case meets it" : between + factor;
  }
  return wrapped(text, "next digit, " + error_text(findings, next->error) + ": ", "  ");
}

Json json_case(const StoredStudy& study, const std::optional<std::size_t>& index) {
  if (!index) return nullptr;
  const StudyCase& one = study.findings.cases[*index];
  const auto threads = threads_of(one);
  Json values = Json::object();
  for (const AxisValue& at : one.values) values[at.axis] = at.value;
  return {{"number", one.number},
          {"label", one.label},
          {"values", values},
          {"folder", json_text(study.case_folder(one))},
          {"command", json_text(command_of(study, one))},
          {"error", json_figure(one.error)},
          {"cost", json_figure(one.cost)},
          {"cost_unit", study.findings.cost_unit},
          {"cost_spread", json_figure(one.cost_spread)},
          {"threads", threads ? Json(*threads) : Json()}};
}

/// How to run the first case that the method completed and whose scene is there.
std::string command_of(const StoredStudy& study, const Survival& best) {
  for (const StudyCase& one : study.findings.cases) {
    if (one.budget || method_of(one) != best.method || !one.completed()) continue;
    const std::string folder = study.case_folder(one);
    if (!folder.empty() && std::filesystem::exists(folder + "/case.yaml")) return "assay run " + folder + "/case.yaml";
  }
  return "";
}

/// What the study's level of that name sets, as YAML on one line; empty where its text does not say.
std::string settings_of(const StoredStudy& study, const Survival& best) {
  try {
    const Tree root = read_yaml(study.findings.study_yaml, study.file);
    const Tree* axes = root.find("axes");
    const Tree* methods = axes ? axes->find("method") : nullptr;
    const Tree* level = methods ? methods->find(best.method) : nullptr;
    return level ? flow_text(*level) : "";
  } catch (const std::exception&) {  // a file that somebody has edited
    return "";
  }
}

}  // namespace

std::string recommendation_text(const StoredStudy& study, const Recommendation& found) {
  const StudyFindings& findings = study.findings;
  const std::string wanted = findings.error_name + " of at most " + error_text(findings, found.error);
  if (!found.best) {
    const std::string text = wrapped("no measured case has a " + wanted + rest_words(findings), "", "  ");
    return text + (found.nearest ? case_lines(study, findings.cases[*found.nearest], "the best found: ")
                                 : "no case can be recommended at all\n");
  }
  std::string text = wrapped(wanted + ":", "for a ", "  ") + case_lines(study, findings.cases[*found.best], "take ");
  if (found.runner_up) {
    text += case_lines(study, findings.cases[*found.runner_up], "by another method: ");
    if (!found.told_apart) text += "  the two costs differ by less than the noise of the clock\n";
  } else {
    text += "by another method: no case meets the error\n";
  }
  const std::string load = load_sentence(findings);
  return text + next_text(findings, found.next) + wrapped(findings.cost_name, "cost: ", "  ") +
         (load.empty() ? "" : wrapped(load, "warning: ", "  "));
}

std::string recommendation_json(const StoredStudy& study, const Recommendation& found) {
  Json out{{"error", found.error},
           {"unit", study.findings.error_unit},
           {"met", found.best.has_value()},
           {"recommended", json_case(study, found.best)},
           {"runner_up", json_case(study, found.runner_up)},
           {"told_apart", found.runner_up ? Json(found.told_apart) : Json()},
           {"nearest", json_case(study, found.nearest)},
           {"next_digit", nullptr}};
  if (const auto& next = found.next) {
    out["next_digit"] = {{"error", next->error},
                         {"best", json_case(study, next->best)},
                         {"interpolated", json_figure(next->interpolated)},
                         {"factor", json_figure(next->factor)}};
  }
  out["load"] = load_json(study.findings);
  return json_document(out);
}

std::string survival_text(const StoredStudy& study, const std::vector<Survival>& found) {
  const Survival* best = hardiest(found);
  if (!best) return "no method can be recommended: none completes a case without the exact solution\n";
  std::string text = wrapped("it completes " + std::to_string(best->completed) + " of the " +
                                 std::to_string(best->asked()) + " cases that apply to it",
                             "take " + best->method + ": ", "  ");
  for (const std::size_t i : best->lost) {
    const StudyCase& one = study.findings.cases[i];
    text += wrapped(one.label + ": " + one.outcome + (one.reason.empty() ? "" : ", " + one.reason), "  ", "    ");
  }
  if (const std::string settings = settings_of(study, *best); !settings.empty())
    text += wrapped(settings, "  its settings: ", "    ");
  if (const std::string command = command_of(study, *best); !command.empty()) text += "  in a scene: " + command + "\n";
  text += "\n" + survival_table(found) + "\n";
  if (const std::string note = unfinished_note(found); !note.empty()) text += wrapped(note, "", "  ");
  return text + wrapped(ratio_note, "error/best: ", "  ");
}

std::string survival_json(const StoredStudy& study, const std::vector<Survival>& found) {
  const Survival* best = hardiest(found);
  Json methods = Json::array();
  for (const Survival& of : found) {
    Json lost = Json::array();
    for (const std::size_t i : of.lost) {
      const StudyCase& one = study.findings.cases[i];
      lost.push_back({{"number", one.number}, {"label", one.label}, {"outcome", one.outcome}, {"reason", one.reason}});
    }
    methods.push_back(JsonFields<Json>::of(of));
    methods.back()["lost"] = lost;
  }
  return json_document({{"recommended", best ? Json(best->method) : Json()},
                        {"settings", json_text(best ? settings_of(study, *best) : "")},
                        {"methods", methods}});
}

}  // namespace assay::drivers
