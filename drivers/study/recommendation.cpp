// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/recommendation.hpp"

#include <algorithm>
#include <cmath>

#include "drivers/study/survival.hpp"
#include "drivers/study/time_noise.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

/// Whatever a file says of it.
bool may_be_taken(const StudyCase& one) {
  return one.eligible && one.completed() && one.error && one.cost && !one.budget && !uses_exact_solution(one);
}

bool is_cheaper(const StudyCase& a, const StudyCase& b) {
  return *a.cost != *b.cost ? *a.cost < *b.cost : *a.error < *b.error;
}

/// The first in that order of the cases that may be taken and of which the condition holds.
template <class Condition, class Less>
std::optional<std::size_t> first_case(const StudyFindings& findings, const Condition& holds, const Less& less) {
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
