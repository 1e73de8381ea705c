// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/findings.hpp"

#include <algorithm>
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
  return static_cast<int>(
      std::count_if(cases.begin(), cases.end(), [&](const StudyCase& one) { return one.outcome == outcome; }));
}

bool StudyFindings::ended_badly(const StudyCase& one) const {
  if (one.outcome != "crashed" && one.outcome != "stopped") return false;
  return std::none_of(expect.begin(), expect.end(), [&](const StudyExpectationOutcome& line) {
    return line.where == one.label && line.outcome.key == "outcome" && line.outcome.holds;
  });
}

bool StudyFindings::holds() const {
  return count("missing") == 0 &&
         std::none_of(cases.begin(), cases.end(), [&](const StudyCase& one) { return ended_badly(one); }) &&
         std::all_of(expect.begin(), expect.end(), [](const auto& line) { return line.outcome.holds; });
}

std::optional<std::size_t> best_case(const StudyFindings& findings) { return extreme(findings, std::less<>()); }
std::optional<std::size_t> worst_case(const StudyFindings& findings) { return extreme(findings, std::greater<>()); }

}  // namespace assay::drivers
