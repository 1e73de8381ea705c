// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/analysis/recommendation.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "drivers/study/analysis/clock.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/text/numbers.hpp"

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

/// Whatever a file says of it.
bool may_be_taken(const StudyCase& one) {
  return one.eligible && one.completed() && one.error && one.cost && !one.budget && !uses_exact_solution(one);
}

bool is_cheaper(const StudyCase& a, const StudyCase& b) {
  return *a.cost != *b.cost ? *a.cost < *b.cost : *a.error < *b.error;
}

/// The first in that order of the cases that may be taken and of which the condition holds.
std::optional<std::size_t> first_case(const StudyFindings& findings, const auto& holds, const auto& less) {
  std::optional<std::size_t> first;
  for (std::size_t i = 0; i < findings.cases.size(); ++i) {
    const StudyCase& one = findings.cases[i];
    if (may_be_taken(one) && holds(one) && (!first || less(one, findings.cases[*first]))) first = i;
  }
  return first;
}

/// The largest level below what the case reaches.
std::optional<NextDigit> digit_after(const StudyFindings& findings, const StudyCase& best, double error) {
  const StudyDigit* next = nullptr;
  for (const StudyDigit& digit : findings.digits) {
    const bool beyond = digit.error < std::min(error, *best.error);
    if (beyond && (!next || digit.error > next->error)) next = &digit;
  }
  if (!next) return std::nullopt;
  NextDigit found{next->error, next->best, next->interpolated, std::nullopt};
  const Figure cost = next->best ? findings.cases[*next->best].cost : next->interpolated;
  if (cost && *best.cost > 0) found.factor = *cost / *best.cost;
  return found;
}

}  // namespace

std::string Survival::completed_text() const { return std::to_string(completed) + " of " + std::to_string(asked()); }

std::string method_of(const StudyCase& one) {
  const std::string method = value_on(one, "method");
  return method.empty() ? one.series : method;
}

const Survival* hardiest(const std::vector<Survival>& found) {
  const bool any = !found.empty() && found.front().completed > 0 && !found.front().uses_exact_solution;
  return any ? &found.front() : nullptr;
}

std::vector<Survival> survivals(const StudyFindings& findings) {
  const auto& axes = findings.axes;
  if (std::ranges::find(axes, "method") == axes.end()) {
    throw InputError({}, "axes.method",
                     "the study has no such axis, whose values could be recommended; --error E asks for a case");
  }
  std::vector<Survival> methods;
  for (std::size_t i = 0; i < findings.cases.size(); ++i) {
    const StudyCase& one = findings.cases[i];
    if (one.budget) continue;
    const std::string method = method_of(one);
    auto at = std::ranges::find_if(methods, [&](const Survival& of) { return of.method == method; });
    if (at == methods.end()) {
      methods.emplace_back().method = method;
      at = methods.end() - 1;
    }
    count(*at, one, i);
  }
  find_ratios(findings, methods);
  std::ranges::stable_sort(methods, is_better);
  return methods;
}

Recommendation recommended(const StudyFindings& findings, double error) {
  Recommendation found;
  found.error = error;
  const auto meets = [&](const StudyCase& one) { return *one.error <= error; };
  found.best = first_case(findings, meets, is_cheaper);
  if (!found.best) {
    found.nearest = first_case(
        findings, [](const StudyCase&) { return true; },
        [](const StudyCase& a, const StudyCase& b) { return *a.error < *b.error; });
    return found;
  }
  const StudyCase& best = findings.cases[*found.best];
  found.runner_up = first_case(
      findings, [&](const StudyCase& one) { return meets(one) && method_of(one) != method_of(best); }, is_cheaper);
  if (found.runner_up) {
    const StudyCase& other = findings.cases[*found.runner_up];
    found.told_apart =
        told_apart(*best.cost, *other.cost, CostNoise(findings, findings).between(best, other).bound) > 0;
  }
  found.next = digit_after(findings, best, error);
  return found;
}

double wanted_error(const StudyFindings& findings, const std::string& text) {
  const std::string found = ", found '" + one_line(text, 60) + "'";
  std::string number = text;
  const bool percent = number.ends_with('%');
  if (percent) {
    number.pop_back();
    number.erase(number.find_last_not_of(' ') + 1);
    if (!findings.error_unit.empty()) {
      throw InputError({}, "--error",
                       "a percentage is of a relative error, that of the study is in " + findings.error_unit + found);
    }
  }
  const auto value = parse_number(number);
  if (!value || !(*value > 0) || !std::isfinite(*value))
    throw InputError({}, "--error", "must be a number above 0, or a percentage such as 1%" + found);
  return percent ? *value / 100 : *value;
}

}  // namespace assay::drivers
