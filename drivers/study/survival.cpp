// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/survival.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "drivers/system/input_error.hpp"

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
  const bool unfinished = one.outcome == "stopped" || one.outcome == "missing";
  ++(one.outcome == "refused" ? of.refused : unfinished ? of.unfinished : of.died);
  of.lost.push_back(index);
}

double middle_of(std::vector<double> values) {
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
    if (!ratios.empty()) method.error_ratio = middle_of(ratios);
  }
}

bool is_better(const Survival& a, const Survival& b) {
  const auto rank = [](const Survival& of) {
    const double share = of.asked() > 0 ? static_cast<double>(of.completed) / of.asked() : 0;
    return std::tuple(of.uses_exact_solution, -share, of.died, -of.asked(), of.error_ratio.value_or(INFINITY));
  };
  return rank(a) < rank(b);
}

}  // namespace

bool uses_exact_solution(const StudyCase& one) {
  const auto found = one.figures.find("uses_exact_solution");
  const bool* flag = found == one.figures.end() ? nullptr : std::get_if<bool>(&found->second);
  return flag && *flag;
}

std::string method_of(const StudyCase& one) {
  for (const AxisValue& at : one.values) {
    if (at.axis == "method") return at.value;
  }
  return one.series;
}

const Survival* hardiest(const std::vector<Survival>& found) {
  const bool any = !found.empty() && found.front().completed > 0 && !found.front().uses_exact_solution;
  return any ? &found.front() : nullptr;
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

}  // namespace assay::drivers
