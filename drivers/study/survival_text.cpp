// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "drivers/format/yaml_reader.hpp"
#include "drivers/study/selection.hpp"
#include "drivers/study/survival.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/text/table_text.hpp"
#include "drivers/text/wrapped_text.hpp"

namespace assay::drivers {

namespace {

std::string lost_text(const StudyFindings& findings, const Survival& best) {
  std::string text;
  for (const std::size_t i : best.lost) {
    const StudyCase& one = findings.cases[i];
    text += wrapped(one.label + ": " + one.outcome + (one.reason.empty() ? "" : ", " + one.reason), "  ", "    ");
  }
  return text;
}

/// Of the first case that the method completed and whose scene is there.
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

std::string unfinished_note(const std::vector<Survival>& found) {
  std::string text;
  for (const Survival& of : found) {
    if (of.unfinished > 0)
      text += (text.empty() ? "" : "; ") + one_line(of.method, 80) + " " + std::to_string(of.unfinished);
  }
  return text.empty() ? text : "Stopped, or not run yet: " + text + ".";
}

std::string survival_table(const std::vector<Survival>& found) {
  constexpr std::size_t widest = 34;
  std::string text = padded("method", widest) + "  completed failed  refused    n/a  error/best\n";
  for (const Survival& of : found) {
    const auto right = [](const std::string& word, std::size_t width) {
      return std::string(width - std::min(width, word.size()), ' ') + word;
    };
    text += table_line(padded(one_line(of.method, widest), widest) +
                       right(std::to_string(of.completed) + " of " + std::to_string(of.asked()), 11) +
                       right(std::to_string(of.died), 7) + right(std::to_string(of.refused), 9) +
                       right(std::to_string(of.not_applicable), 7) + right(measured_text(of.error_ratio), 12));
  }
  return text;
}

std::string survival_text(const StoredStudy& study, const std::vector<Survival>& found) {
  const Survival* first = hardiest(found);
  if (!first) {
    return "no method can be recommended: none completes a case without the exact solution\n";
  }
  const Survival& best = *first;
  std::string text = wrapped("it completes " + std::to_string(best.completed) + " of the " +
                                 std::to_string(best.asked()) + " cases that apply to it",
                             "take " + best.method + ": ", "  ");
  text += lost_text(study.findings, best);
  if (const std::string settings = settings_of(study, best); !settings.empty())
    text += wrapped(settings, "  its settings: ", "    ");
  if (const std::string command = command_of(study, best); !command.empty()) text += "  in a scene: " + command + "\n";
  text += "\n";
  text += survival_table(found) + "\n";
  if (const std::string note = unfinished_note(found); !note.empty()) text += wrapped(note, "", "  ");
  return text + wrapped(ratio_note, "error/best: ", "  ");
}

std::string survival_json(const StoredStudy& study, const std::vector<Survival>& found) {
  using Json = nlohmann::ordered_json;
  Json out;
  const Survival* best = hardiest(found);
  out["recommended"] = best ? Json(best->method) : Json(nullptr);
  const std::string settings = best ? settings_of(study, *best) : "";
  out["settings"] = settings.empty() ? Json(nullptr) : Json(settings);
  out["methods"] = Json::array();
  for (const Survival& of : found) {
    Json one{{"method", of.method},
             {"completed", of.completed},
             {"died", of.died},
             {"refused", of.refused},
             {"unfinished", of.unfinished},
             {"not_applicable", of.not_applicable},
             {"uses_exact_solution", of.uses_exact_solution},
             {"error_ratio", of.error_ratio ? Json(*of.error_ratio) : Json(nullptr)},
             {"lost", Json::array()}};
    for (const std::size_t i : of.lost) {
      const StudyCase& lost = study.findings.cases[i];
      one["lost"].push_back(
          {{"number", lost.number}, {"label", lost.label}, {"outcome", lost.outcome}, {"reason", lost.reason}});
    }
    out["methods"].push_back(one);
  }
  return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace assay::drivers
