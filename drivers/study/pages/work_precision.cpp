// SPDX-License-Identifier: BSD-3-Clause
// What a diagram of error over cost shows.
#include "drivers/study/pages/study_figures.hpp"

#include <algorithm>
#include <utility>

#include "drivers/study/pages/words.hpp"

namespace assay::drivers {

namespace {

Figure drawable(const Figure& value) { return value && *value > 1e-280 && *value < 1e280 ? value : std::nullopt; }

Figure cost_of(const StudyCase& one, CostAxis axis) { return drawable(axis == CostAxis::cost ? one.cost : one.work); }

/// What a case had cost when it ended.
Figure reached(const StudyFindings& findings, const StudyCase& one, CostAxis axis) {
  const Figure known = cost_of(one, axis);
  const std::string key = axis == CostAxis::work ? "work.particle_steps" : findings.cost_key;
  return known ? known : drawable(number_of(one, key));
}

std::optional<WorkPoint> point_of(const StudyFindings& findings, std::size_t index, CostAxis axis) {
  const StudyCase& one = findings.cases[index];
  const Figure cost = cost_of(one, axis), error = drawable(one.error);
  if (!one.completed() || !cost || !error) return std::nullopt;
  return WorkPoint{index, *cost, *error};
}

const std::vector<std::size_t>& front_of(const StudyFindings& findings, CostAxis axis) {
  return axis == CostAxis::cost ? findings.front : findings.work_front;
}

bool dies(const StudyCase& one) { return !one.completed() && one.outcome != "n/a" && one.outcome != "missing"; }

WorkCurve curve_of(const StudyFindings& findings, const StudySeries& series, CostAxis axis) {
  WorkCurve curve{series.name, {{}}, {}, false};
  for (const std::size_t index : series.cases) {
    const auto point = point_of(findings, index, axis);
    if (point) {
      curve.runs.back().push_back(*point);
      curve.exact = curve.exact || !findings.cases[index].eligible;
    } else if (!curve.runs.back().empty()) {
      curve.runs.emplace_back();
    }
  }
  if (curve.runs.back().empty()) curve.runs.pop_back();
  return curve;
}

/// How many cases of a series are on the front.
std::size_t share_of_front(const StudySeries& series, const std::vector<std::size_t>& front) {
  return static_cast<std::size_t>(std::ranges::count_if(
      series.cases, [&](std::size_t index) { return std::ranges::find(front, index) != front.end(); }));
}

/// The series that make up most of the front come first; beyond the palette all others are grey.
void color_front(const StudyFindings& findings, const std::vector<std::size_t>& front, WorkPrecision& out) {
  constexpr std::size_t palette = 7;
  std::vector<std::pair<std::size_t, std::size_t>> order;  // cases on the front, series
  for (std::size_t k = 0; k < findings.series.size(); ++k) {
    const std::size_t share = share_of_front(findings.series[k], front);
    if (share > 0) order.emplace_back(share, k);
  }
  std::ranges::stable_sort(order, [](const auto& a, const auto& b) { return a.first > b.first; });
  for (std::size_t i = 0; i < std::min(order.size(), palette); ++i) out.curves[order[i].second].color = i;
}

/// The eligible case of least work with at most this error; none where no case meets it.
std::optional<std::size_t> least_work(const StudyFindings& findings, double error) {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < findings.cases.size(); ++i) {
    const StudyCase& one = findings.cases[i];
    if (!one.eligible || one.budget || !one.work || !one.error || *one.error > error) continue;
    if (!found || *one.work < *findings.cases[*found].work) found = i;
  }
  return found;
}

std::vector<WorkLevel> levels_of(const StudyFindings& findings, CostAxis axis) {
  std::vector<WorkLevel> levels;
  for (const StudyDigit& digit : findings.digits) {
    WorkLevel level{digit.error, {}, {}};
    if (axis == CostAxis::cost) {
      level.cost = drawable(digit.interpolated ? digit.interpolated : digit.cost);
      level.factor = digit.factor;
    } else if (const auto least = least_work(findings, digit.error)) {
      level.cost = drawable(findings.cases[*least].work);
      const Figure before = levels.empty() ? std::nullopt : levels.back().cost;
      if (level.cost && before) level.factor = *level.cost / *before;
    }
    levels.push_back(level);
  }
  return levels;
}

}  // namespace

WorkPrecision work_precision(const StudyFindings& findings, CostAxis axis) {
  WorkPrecision out;
  for (const StudySeries& series : findings.series) out.curves.push_back(curve_of(findings, series, axis));
  color_front(findings, front_of(findings, axis), out);
  for (const std::size_t index : front_of(findings, axis)) {
    if (const auto point = point_of(findings, index, axis)) out.front.push_back(*point);
  }
  for (std::size_t k = 0; k < findings.series.size(); ++k) {
    for (const std::size_t index : findings.series[k].cases) {
      const StudyCase& one = findings.cases[index];
      if (dies(one)) out.deaths.push_back({index, reached(findings, one, axis), out.curves[k].color});
    }
  }
  out.levels = levels_of(findings, axis);
  return out;
}

std::string tip_of(const StudyFindings& findings, const StudyCase& one) {
  std::string text = one.label + ": " + outcome_text(one);
  if (one.completed() && one.error) text += ", error " + error_text(findings, *one.error);
  if (one.completed() && one.cost) text += ", " + cost_text(findings, *one.cost);
  return one.reason.empty() ? text : text + ". " + one.reason;
}

}  // namespace assay::drivers
