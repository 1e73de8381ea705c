// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/analysis/findings.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "drivers/scene/expect.hpp"
#include "drivers/study/plan/study_reader.hpp"

namespace assay::drivers {

namespace {

std::optional<std::size_t> extreme(const StudyFindings& findings, const auto& better) {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < findings.cases.size(); ++i) {
    const StudyCase& one = findings.cases[i];
    if (!one.completed() || !one.error || one.budget) continue;
    if (!found || better(*one.error, *findings.cases[*found].error)) found = i;
  }
  return found;
}

FlatValue value_of(const Figure& figure) { return figure ? FlatValue(*figure) : FlatValue(); }

FlatValue found_of(const StudyCase& one, const std::string& key) {
  if (key == "outcome") return one.outcome;
  if (key == "reason") return one.reason;
  const auto found = one.figures.find(key);
  return found == one.figures.end() ? FlatValue() : found->second;
}

/// Of the finest; a case that cannot be has no resolution, and stands behind all others.
Figure last_order(const StudyFindings& findings, const StudySeries& series) {
  for (std::size_t k = std::min(series.cases.size(), series.pairwise.size()); k > 0; --k) {
    if (findings.cases[series.cases[k - 1]].resolution) return series.pairwise[k - 1];
  }
  return {};
}

FlatValue order_of(const StudyFindings& findings, const StudySeries& series, const std::string& key) {
  if (key == last_order_key) return value_of(last_order(findings, series));
  return value_of(series.fit ? Figure(series.fit->order) : Figure());
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

std::vector<StudyExpectationOutcome> judged_of(const Study& study, const StudyFindings& findings) {
  std::vector<StudyExpectationOutcome> outcomes;
  const auto meant = [&](const StudyExpectation& each, std::size_t i) {
    return !findings.cases[i].budget && each.where.holds(findings.cases[i].values);
  };
  /// Whether that line's `outcome: completed` is told of the case already, by a line of the author or an earlier one.
  const auto is_said = [&](const StudyExpectation& implied, std::size_t i) {
    return std::ranges::any_of(study.expect, [&](const StudyExpectation& each) {
      return each.line.key == implied.line.key && each.line.text == implied.line.text && meant(each, i) &&
             (!each.implied || &each < &implied);
    });
  };
  for (const StudyExpectation& each : study.expect) {
    const std::string& key = each.line.key;
    const std::size_t before = outcomes.size();
    if (key == order_key || key == last_order_key) {
      for (const StudySeries& series : findings.series) {
        const auto& cases = series.cases;
        if (std::ranges::any_of(cases, [&](std::size_t i) { return meant(each, i); }))
          outcomes.push_back({series.name, judged(each.line, order_of(findings, series, key))});
      }
    } else {
      for (std::size_t i = 0; i < findings.cases.size(); ++i) {
        if (meant(each, i) && !(each.implied && (findings.cases[i].completed() || is_said(each, i))))
          outcomes.push_back({findings.cases[i].label, judged(each.line, found_of(findings.cases[i], key))});
      }
    }
    if (outcomes.size() == before && !each.implied) outcomes.push_back({"no case", judged(each.line, FlatValue())});
  }
  return outcomes;
}

}  // namespace assay::drivers
