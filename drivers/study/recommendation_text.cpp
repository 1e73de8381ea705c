// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>
#include <nlohmann/json.hpp>

#include "drivers/result/json_figure.hpp"
#include "drivers/study/clock.hpp"
#include "drivers/study/recommendation.hpp"
#include "drivers/study/study_json.hpp"
#include "drivers/study/study_words.hpp"
#include "drivers/text/number_format.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/wrapped_text.hpp"

namespace assay::drivers {

namespace {

using Json = nlohmann::ordered_json;

std::string with_unit(double value, const std::string& unit) {
  return rounded_text(value, 3) + (unit.empty() ? "" : " " + unit);
}

std::string cost_with_spread(const StudyFindings& findings, const StudyCase& one) {
  std::string text = with_unit(*one.cost, findings.cost_unit);
  if (one.cost_spread) return text + " (+- " + rounded_text(100 * *one.cost_spread, 2) + " %)";
  return findings.cost_unit == "s" ? text + " (one run: no spread)" : text;
}

/// The axis `threads`, or what the case's figures say.
std::optional<std::int64_t> threads_of(const StudyCase& one) {
  for (const AxisValue& at : one.values) {
    if (at.axis == "threads") return parse_integer(at.value);
  }
  const auto found = one.figures.find("threads");
  const double* threads = found == one.figures.end() ? nullptr : std::get_if<double>(&found->second);
  if (threads && *threads >= 1 && *threads <= 4096) return static_cast<std::int64_t>(*threads);
  return std::nullopt;
}

/// The word as the shell takes it.
std::string shell_word(const std::string& word) {
  if (!word.empty() &&
      word.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./=:,+-") == word.npos)
    return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + "'";
}

/// case.yaml holds all that the axes have set.
std::string command_of(const StoredStudy& study, const StudyCase& one) {
  const std::string folder = study.case_folder(one);
  if (folder.empty()) return {};
  std::string command = "assay run " + shell_word((std::filesystem::path(folder) / "case.yaml").string());
  if (const auto threads = threads_of(one)) command += " --threads " + std::to_string(*threads);
  return command;
}

std::string figures_line(const StudyFindings& findings, const StudyCase& one) {
  const auto threads = threads_of(one);
  return "error " + error_text(findings, *one.error) + ", cost " + cost_with_spread(findings, one) +
         (threads ? ", " + std::to_string(*threads) + (*threads == 1 ? " thread" : " threads")
                  : ", threads not recorded");
}

std::string case_lines(const StoredStudy& study, const StudyCase& one) {
  const std::string command = command_of(study, one);
  return wrapped(figures_line(study.findings, one), "  ", "    ") + (command.empty() ? "" : "  " + command + "\n");
}

std::string next_text(const StoredStudy& study, const std::optional<NextDigit>& next) {
  if (!next) return "next digit: the study has no finer level\n";
  const StudyFindings& findings = study.findings;
  const std::string first = "next digit, " + error_text(findings, next->error) + ": ";
  const std::string factor = next->factor ? ", " + rounded_text(*next->factor, 3) + " times the cost" : "";
  std::string between;
  if (next->interpolated) between = with_unit(*next->interpolated, findings.cost_unit) + " between resolutions";
  if (next->best && findings.cases[*next->best].cost) {
    const StudyCase& one = findings.cases[*next->best];
    return wrapped(
        one.label + ", " + cost_with_spread(findings, one) + factor + (between.empty() ? "" : "; " + between), first,
        "  ");
  }
  return wrapped(between.empty() ? "no measured case meets it" : between + factor, first, "  ");
}

Json json_case(const StoredStudy& study, const std::optional<std::size_t>& index) {
  if (!index) return nullptr;
  const StudyCase& one = study.findings.cases[*index];
  const auto threads = threads_of(one);
  const std::string folder = study.case_folder(one);
  Json out;
  out["number"] = one.number;
  out["label"] = one.label;
  out["values"] = Json::object();
  for (const AxisValue& at : one.values) out["values"][at.axis] = at.value;
  out["folder"] = json_text(folder);
  out["command"] = folder.empty() ? Json(nullptr) : Json(command_of(study, one));
  out["error"] = json_figure(one.error);
  out["cost"] = json_figure(one.cost);
  out["cost_unit"] = study.findings.cost_unit;
  out["cost_spread"] = json_figure(one.cost_spread);
  out["threads"] = threads ? Json(*threads) : Json(nullptr);
  return out;
}

}  // namespace

std::string recommendation_text(const StoredStudy& study, const Recommendation& found) {
  const StudyFindings& findings = study.findings;
  const std::string wanted = findings.error_name + " of at most " + error_text(findings, found.error);
  if (!found.best) {
    std::string text = wrapped("no measured case has a " + wanted + rest_words(findings), "", "  ");
    if (!found.nearest) return text + "no case can be recommended at all\n";
    const StudyCase& nearest = findings.cases[*found.nearest];
    return text + wrapped(nearest.label, "the best found: ", "  ") + case_lines(study, nearest);
  }
  const StudyCase& best = findings.cases[*found.best];
  std::string text =
      wrapped(wanted + ":", "for a ", "  ") + wrapped(best.label, "take ", "  ") + case_lines(study, best);
  if (found.runner_up) {
    const StudyCase& other = findings.cases[*found.runner_up];
    text += wrapped(other.label, "by another method: ", "  ") + case_lines(study, other);
    if (!found.told_apart) text += "  the two costs differ by less than the noise of the clock\n";
  } else {
    text += "by another method: no case meets the error\n";
  }
  const std::string load = load_sentence(findings);
  return text + next_text(study, found.next) + wrapped(findings.cost_name, "cost: ", "  ") +
         (load.empty() ? "" : wrapped(load, "warning: ", "  "));
}

std::string recommendation_json(const StoredStudy& study, const Recommendation& found) {
  Json out;
  out["error"] = found.error;
  out["unit"] = study.findings.error_unit;
  out["met"] = found.best.has_value();
  out["recommended"] = json_case(study, found.best);
  out["runner_up"] = json_case(study, found.runner_up);
  out["told_apart"] = found.runner_up ? Json(found.told_apart) : Json(nullptr);
  out["nearest"] = json_case(study, found.nearest);
  out["next_digit"] = nullptr;
  if (const auto& next = found.next) {
    out["next_digit"] = Json::object({{"error", next->error},
                                      {"best", json_case(study, next->best)},
                                      {"interpolated", json_figure(next->interpolated)},
                                      {"factor", json_figure(next->factor)}});
  }
  out["load"] = load_json(study.findings);
  return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace assay::drivers
