// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "drivers/input_error.hpp"
#include "drivers/output/table_text.hpp"
#include "drivers/output/wrapped_text.hpp"
#include "drivers/study/survival.hpp"

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

}  // namespace

std::string survival_table(const std::vector<Survival>& found) {
  constexpr std::size_t widest = 34;
  std::string text = padded("method", widest) + "  completed   died  refused    n/a  error/best\n";
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
  if (const std::string command = command_of(study, best); !command.empty())
    text += "  its settings: " + command + "\n";
  text += "\n";
  return text + survival_table(found) + "\n" + wrapped(ratio_note, "error/best: ", "  ");
}

std::string survival_json(const StoredStudy& study, const std::vector<Survival>& found) {
  using Json = nlohmann::ordered_json;
  Json out;
  const Survival* best = hardiest(found);
  out["recommended"] = best ? Json(best->method) : Json(nullptr);
  out["methods"] = Json::array();
  for (const Survival& of : found) {
    Json one{{"method", of.method},
             {"completed", of.completed},
             {"died", of.died},
             {"refused", of.refused},
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
