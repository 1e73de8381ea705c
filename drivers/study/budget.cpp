// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/budget.hpp"

#include <algorithm>
#include <cmath>

namespace assay::drivers {

namespace {

/// Linear between two samples; absent beyond the ends.
Figure value_at(const std::vector<std::array<double, 2>>& history, double t) {
  const auto after = std::lower_bound(history.begin(), history.end(), t,
                                      [](const std::array<double, 2>& sample, double at) { return sample[0] < at; });
  if (after == history.end()) return std::nullopt;
  if ((*after)[0] == t) return (*after)[1];
  if (after == history.begin()) return std::nullopt;
  const auto& [t0, a] = *(after - 1);
  const auto& [t1, b] = *after;
  return a + (b - a) * (t - t0) / (t1 - t0);
}

std::string text_of(const std::vector<Setting>& settings) {
  std::string text;
  for (const Setting& setting : settings) {
    text += (text.empty() ? "" : ", ") + setting.path + "=" + flow_text(setting.value);
  }
  return text;
}

}  // namespace

Figure largest_change(const std::vector<std::array<double, 2>>& base, const std::vector<std::array<double, 2>>& other) {
  double largest = 0, change = 0;
  bool any = false;
  for (const auto& [t, value] : base) {
    largest = std::max(largest, std::abs(value));
    const Figure refined = value_at(other, t);
    if (!refined) continue;
    any = true;
    change = std::max(change, std::abs(*refined - value));
  }
  if (!any || !(largest > 0)) return std::nullopt;
  return change / largest;
}

std::vector<BudgetLine> budget_of(const Plan& plan, const std::vector<StudyCase>& cases) {
  std::vector<BudgetLine> lines;
  for (std::size_t i = 0; i < plan.cases.size(); ++i) {
    const PlannedCase& planned = plan.cases[i];
    if (!planned.base) continue;
    const BudgetSource& source = plan.study.budget->sources[planned.source];
    const StudyCase &base = cases[*planned.base], &refined = cases[i];
    BudgetLine line{base.label, source.name, text_of(source.settings), base.error, refined.error, {}, refined.outcome};
    if (base.completed() && refined.completed()) line.share = largest_change(base.history, refined.history);
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace assay::drivers
