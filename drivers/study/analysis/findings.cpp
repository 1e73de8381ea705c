// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/analysis/findings.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace assay::drivers {

namespace {

template <class Better>
std::optional<std::size_t> extreme(const StudyFindings& findings, const Better& better) {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < findings.cases.size(); ++i) {
    const StudyCase& one = findings.cases[i];
    if (!one.completed() || !one.error || one.budget) continue;
    if (!found || better(*one.error, *findings.cases[*found].error)) found = i;
  }
  return found;
}

}  // namespace

int StudyFindings::count(const std::string& outcome) const {
  return static_cast<int>(std::ranges::count_if(cases, [&](const StudyCase& one) { return one.outcome == outcome; }));
}

bool StudyFindings::ended_badly(const StudyCase& one) const {
  if (one.outcome != "crashed" && one.outcome != "stopped") return false;
  return std::ranges::none_of(expect, [&](const StudyExpectationOutcome& line) {
    return line.where == one.label && line.outcome.key == "outcome" && line.outcome.holds;
  });
}

bool StudyFindings::holds() const {
  return count("missing") == 0 && std::ranges::none_of(cases, [&](const StudyCase& one) { return ended_badly(one); }) &&
         std::ranges::all_of(expect, [](const auto& line) { return line.outcome.holds; });
}

std::optional<std::size_t> best_case(const StudyFindings& findings) { return extreme(findings, std::less<>()); }
std::optional<std::size_t> worst_case(const StudyFindings& findings) { return extreme(findings, std::greater<>()); }

Figure number_of(const StudyCase& one, const std::string& key) {
  const auto* number = value_in<double>(one.figures, key);
  return number && std::isfinite(*number) ? Figure(*number) : std::nullopt;
}

std::string value_on(const StudyCase& one, const std::string& axis) {
  for (const AxisValue& at : one.values) {
    if (at.axis == axis) return at.value;
  }
  return {};
}

bool is_at_rest(const StudyFindings& findings, const StudyCase& one) {
  return findings.error_key == "error.relative" && one.completed() && !one.error && number_of(one, "error.l2_max");
}

std::string rest_words(const StudyFindings& findings) {
  const auto count =
      std::ranges::count_if(findings.cases, [&](const StudyCase& one) { return is_at_rest(findings, one); });
  if (count == 0) return {};
  return ": the exact displacement is zero in " + std::to_string(count) + (count == 1 ? " case" : " cases") +
         ", and a relative error is undefined there; error: error.l2_max is one in metres";
}

std::string cases_text(std::ptrdiff_t count) {
  return std::to_string(count) + (count == 1 ? " case was" : " cases were");
}

bool uses_exact_solution(const StudyCase& one) {
  const auto* flag = value_in<bool>(one.figures, "uses_exact_solution");
  return flag && *flag;
}

}  // namespace assay::drivers
