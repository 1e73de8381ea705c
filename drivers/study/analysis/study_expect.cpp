// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/analysis/analysis.hpp"

#include <algorithm>

#include "drivers/scene/expect.hpp"
#include "drivers/study/plan/study_reader.hpp"

namespace assay::drivers {

namespace {

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
