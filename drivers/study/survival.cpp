// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/survival.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>

#include "drivers/input_error.hpp"
#include "drivers/output/table_text.hpp"
#include "drivers/output/wrapped_text.hpp"

namespace assay::drivers {

namespace {

/// The case without its method: what it shares with those of other methods.
std::string place_of(const StudyCase& one) {
  std::string name;
  for (const AxisValue& at : one.values) {
    if (at.axis != "method") name += at.axis + "=" + at.value + ";";
  }
  return name;
}

bool uses_exact_solution(const StudyCase& one) {
  const auto found = one.figures.find("uses_exact_solution");
  const bool* flag = found == one.figures.end() ? nullptr : std::get_if<bool>(&found->second);
  return flag && *flag;
}

void count(Survival& of, const StudyCase& one, std::size_t index) {
  if (one.outcome == "n/a") {
    ++of.not_applicable;
    return;
  }
  if (one.completed()) {
    of.uses_exact_solution = uses_exact_solution(one) && (of.completed == 0 || of.uses_exact_solution);
    ++of.completed;
    return;
  }
  ++(one.outcome == "refused" ? of.refused : of.died);
  of.lost.push_back(index);
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return 0.5 * (values[(values.size() - 1) / 2] + values[values.size() / 2]);
}

void find_ratios(const StudyFindings& findings, std::vector<Survival>& methods) {
  std::map<std::string, double> best;  // by place
  for (const StudyCase& one : findings.cases) {
    if (one.budget || !one.completed() || !one.error || !(*one.error > 0) || uses_exact_solution(one)) continue;
    const auto [at, is_new] = best.try_emplace(place_of(one), *one.error);
    if (!is_new) at->second = std::min(at->second, *one.error);
  }
  for (Survival& method : methods) {
    std::vector<double> ratios;
    for (const StudyCase& one : findings.cases) {
      if (one.budget || method_of(one) != method.method || !one.completed() || !one.error || !(*one.error > 0))
        continue;
      const auto at = best.find(place_of(one));
      if (at != best.end()) ratios.push_back(*one.error / at->second);
    }
    if (!ratios.empty()) method.error_ratio = median(ratios);
  }
}

bool is_better(const Survival& a, const Survival& b) {
  const auto rank = [](const Survival& of) {
    const double share = of.asked() > 0 ? static_cast<double>(of.completed) / of.asked() : 0;
    return std::tuple(of.uses_exact_solution, -share, of.died, -of.asked(), of.error_ratio.value_or(INFINITY));
  };
  return rank(a) < rank(b);
}

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

std::string method_of(const StudyCase& one) {
  for (const AxisValue& at : one.values) {
    if (at.axis == "method") return at.value;
  }
  return one.series;
}

std::vector<Survival> survivals(const StudyFindings& findings) {
  const auto& axes = findings.axes;
  if (std::find(axes.begin(), axes.end(), "method") == axes.end()) {
    throw InputError({}, "axes.method",
                     "the study has no such axis, whose values could be recommended; --error E asks for a case");
  }
  std::vector<Survival> methods;
  for (std::size_t i = 0; i < findings.cases.size(); ++i) {
    const StudyCase& one = findings.cases[i];
    if (one.budget) continue;
    const std::string method = method_of(one);
    auto at = std::find_if(methods.begin(), methods.end(), [&](const Survival& of) { return of.method == method; });
    if (at == methods.end()) {
      methods.emplace_back().method = method;
      at = methods.end() - 1;
    }
    count(*at, one, i);
  }
  find_ratios(findings, methods);
  std::stable_sort(methods.begin(), methods.end(), is_better);
  return methods;
}

std::string survival_text(const StoredStudy& study, const std::vector<Survival>& found) {
  if (found.empty() || found.front().completed == 0 || found.front().uses_exact_solution) {
    return "no method can be recommended: none completes a case without the exact solution\n";
  }
  constexpr std::size_t widest = 34;
  const Survival& best = found.front();
  std::string text = wrapped("it completes " + std::to_string(best.completed) + " of the " +
                                 std::to_string(best.asked()) + " cases that apply to it",
                             "take " + best.method + ": ", "  ");
  text += lost_text(study.findings, best);
  if (const std::string command = command_of(study, best); !command.empty())
    text += "  its settings: " + command + "\n";
  text += "\n";
  text += padded("method", widest) + "  completed   died  refused    n/a  error/best\n";
  for (const Survival& of : found) {
    const auto right = [](const std::string& word, std::size_t width) {
      return std::string(width - std::min(width, word.size()), ' ') + word;
    };
    text += table_line(padded(one_line(of.method, widest), widest) +
                       right(std::to_string(of.completed) + " of " + std::to_string(of.asked()), 11) +
                       right(std::to_string(of.died), 7) + right(std::to_string(of.refused), 9) +
                       right(std::to_string(of.not_applicable), 7) + right(measured_text(of.error_ratio), 12));
  }
  return text + "\n" +
         wrapped(
             "the median, over the cases that a method completes, of its error over the smallest that any method has "
             "there. n/a is no pass: such a case asks nothing of the method",
             "error/best: ", "  ");
}

std::string survival_json(const StoredStudy& study, const std::vector<Survival>& found) {
  using Json = nlohmann::ordered_json;
  Json out;
  const bool any = !found.empty() && found.front().completed > 0 && !found.front().uses_exact_solution;
  out["recommended"] = any ? Json(found.front().method) : Json(nullptr);
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
