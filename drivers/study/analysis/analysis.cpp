// SPDX-License-Identifier: BSD-3-Clause
// From a study's cases to orders, fronts, costs and budgets.
#include "drivers/study/analysis/findings.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "drivers/result/result.hpp"
#include "drivers/result/result_json.hpp"
#include "drivers/study/analysis/clock.hpp"
#include "drivers/text/numbers.hpp"
#include "harness/numeric/convergence.hpp"

namespace assay::drivers {

namespace {

/// Linear between two samples; absent beyond the ends.
Figure value_at(const std::vector<std::array<double, 2>>& history, double t) {
  const auto after = std::ranges::lower_bound(history, t, {}, [](const auto& sample) { return sample[0]; });
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

/// The readings of a clock that is the study's figure of cost; null where the cost is counted, not timed.
const std::vector<double>* readings_of(const StudyCase& one, const std::string& cost) {
  return cost == "step_cpu_s" ? &one.clock.step_s
         : cost == "cpu_s"    ? &one.clock.cpu_s
         : cost == "wall_s"   ? &one.clock.wall_s
                              : nullptr;
}

void fill_figures(const Study& study, StudyCase& one) {
  one.work = number_of(one, work_key);
  if (one.completed()) one.error = number_of(one, study.error);
  if (const auto* readings = readings_of(one, study.cost)) {
    if (one.clock.alone && !readings->empty()) {
      one.cost = median(*readings);
      const auto [low, high] = std::ranges::minmax_element(*readings);
      if (readings->size() > 1 && *one.cost > 0) one.cost_spread = 0.5 * (*high - *low) / *one.cost;
    }
  } else {
    one.cost = number_of(one, study.cost);
  }
  one.eligible = one.error && (one.cost || one.work) && !uses_exact_solution(one) && !one.budget;
}

void judge_orders(const std::vector<StudyCase>& cases, StudySeries& series) {
  std::vector<double> h, error;
  for (const std::size_t i : series.cases) {
    if (!cases[i].error || !cases[i].resolution) continue;
    h.push_back(*cases[i].resolution), error.push_back(*cases[i].error);
  }
  const auto pairwise = pairwise_orders(h, error);
  std::size_t next = 0;
  for (const std::size_t i : series.cases) {
    series.pairwise.push_back(cases[i].error && cases[i].resolution ? pairwise[next++] : std::nullopt);
  }
  series.fit = fitted_order(h, error);
  const RangeJudgement judgement = asymptotic_range(h, error);
  series.asymptotic = judgement.range;
  series.sentence = judgement.sentence;
}

/// Series in the order in which they first appear.
std::vector<StudySeries> series_of(const std::vector<StudyCase>& cases) {
  std::vector<StudySeries> all;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (cases[i].budget) continue;
    auto at = std::ranges::find_if(all, [&](const auto& each) { return each.name == cases[i].series; });
    if (at == all.end()) at = all.insert(all.end(), StudySeries{cases[i].series, {}, {}, {}, {}, {}});
    at->cases.push_back(i);
  }
  for (StudySeries& series : all) {
    std::ranges::stable_sort(series.cases, [&](std::size_t a, std::size_t b) {
      return cases[a].resolution.value_or(0) > cases[b].resolution.value_or(0);
    });
    judge_orders(cases, series);
  }
  return all;
}

void take_published(const Study& study, const std::vector<StudyCase>& cases, StudySeries& series) {
  for (const PublishedOrder& published : study.published) {
    const auto meant = [&](std::size_t i) { return published.where.holds(cases[i].values); };
    if (std::ranges::any_of(series.cases, meant)) series.published = published.order, series.source = published.source;
  }
}

StudyDigit digit_of(const StudyFindings& findings, double level) {
  StudyDigit digit{level, {}, {}, {}, {}, {}};
  for (const std::size_t i : findings.front) {  // by cost: the first that meets it is the cheapest
    if (*findings.cases[i].error > level) continue;
    digit.best = i, digit.cost = findings.cases[i].cost;
    break;
  }
  for (const StudySeries& series : findings.series) {
    const Figure cost = cost_at(findings.cases, series, level);
    if (cost && (!digit.interpolated || *cost < *digit.interpolated))
      digit.interpolated = cost, digit.series = series.name;
  }
  return digit;
}

/// One line for each power of ten that the cases reach, and for the first that none does.
std::vector<StudyDigit> digits_of(const StudyFindings& findings) {
  std::vector<StudyDigit> digits;
  if (findings.front.empty()) return digits;
  double largest = 0, smallest = 0;
  for (const std::size_t i : findings.front) {  // errors fall along it
    if (*findings.cases[i].error > 0) smallest = *findings.cases[i].error;
  }
  for (const StudyCase& one : findings.cases) {
    if (one.eligible && one.cost) largest = std::max(largest, *one.error);
  }
  if (!(smallest > 0) || !std::isfinite(largest)) return digits;
  const bool relative = findings.error_key == "error.relative";  // an error of all that there is is no accuracy
  const int first = std::min(static_cast<int>(std::floor(std::log10(largest))), relative ? -1 : 400);
  int last = std::min(first, static_cast<int>(std::floor(std::log10(smallest))));
  if (smallest <= rounded_power(last)) --last;
  for (int k = first; k >= last; --k) {
    const StudyDigit digit = digit_of(findings, rounded_power(k));
    // Accuracy that costs no more than less of it: one line for all.
    if (!digits.empty() && digit.best && digit.best == digits.back().best &&
        digit.interpolated == digits.back().interpolated) {
      digits.back().error = digit.error;
      continue;
    }
    digits.push_back(digit);
    if (digits.size() > 1) {
      const Figure before = digits.end()[-2].interpolated, now = digits.back().interpolated;
      if (before && now && *before > 0) digits.back().factor = *now / *before;
    }
  }
  return digits;
}

std::vector<std::string> warnings_of(const Plan& plan, const StudyFindings& findings) {
  std::vector<std::string> warnings;
  const auto count_of = [&](const auto& is) { return std::ranges::count_if(findings.cases, is); };
  const auto untimed = count_of([](const StudyCase& one) { return one.error && !one.cost && !one.budget; });
  if (untimed > 0) {
    warnings.push_back(cases_text(untimed) + " completed and not timed: without a cost in " + findings.cost_key +
                       " only particle-steps are compared");
  }
  if (std::string load = load_sentence(findings); !load.empty()) warnings.push_back(std::move(load));
  if (plan.study.budget && findings.budget.empty()) warnings.emplace_back("budget: no case is among those of 'of'");
  for (const BudgetLine& line : findings.budget) {
    if (line.share && *line.share == 0)
      warnings.push_back("budget: " + line.changed + " changes nothing: the run of '" + line.source + "' is the same");
  }
  if (findings.machines.size() > 1)
    warnings.emplace_back("the cases were run on different machines: their costs cannot be compared");
  if (const int missing = findings.count("missing"); missing > 0)
    warnings.push_back(std::to_string(missing) + " of " + std::to_string(plan.cases.size()) + " cases are missing");
  return warnings;
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

std::vector<std::size_t> pareto_front(const std::vector<StudyCase>& cases, Figure StudyCase::*cost) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (cases[i].eligible && cases[i].*cost) order.push_back(i);
  }
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    return std::pair(*(cases[a].*cost), *cases[a].error) < std::pair(*(cases[b].*cost), *cases[b].error);
  });
  std::vector<std::size_t> front;
  for (const std::size_t i : order) {
    if (front.empty() || *cases[i].error < *cases[front.back()].error) front.push_back(i);
  }
  return front;
}

Figure cost_at(const std::vector<StudyCase>& cases, const StudySeries& series, double error) {
  Figure least;
  const StudyCase* coarser = nullptr;
  for (const std::size_t i : series.cases) {
    const StudyCase& one = cases[i];
    if (!one.eligible || !one.cost) continue;
    Figure cost;
    if (!coarser && *one.error <= error) cost = one.cost;
    if (coarser && *coarser->error >= error && *one.error <= error) {
      const double span = std::log(*coarser->error / *one.error);
      const double share = span > 0 ? std::log(*coarser->error / error) / span : 0;
      const bool to_zero = *one.error <= 0 && error < *coarser->error;  // there is no line
      cost = to_zero ? *one.cost : *coarser->cost * std::pow(*one.cost / *coarser->cost, share);
    }
    if (cost && std::isfinite(*cost) && (!least || *cost < *least)) least = cost;
    coarser = &one;
  }
  return least;
}

StudyFindings analysed(const Plan& plan, std::vector<StudyCase> cases) {
  Study study = plan.study;
  const bool untimed = study.timing.none && name_and_unit(study.cost).second == "s";
  if (untimed) study.cost = work_key;
  StudyFindings findings;
  findings.title = study.title, findings.question = study.question, findings.study_yaml = study.text;
  findings.asks_survival = study.asks_survival;
  findings.error_key = study.error, findings.cost_key = study.cost, findings.refine_key = study.refine;
  std::tie(findings.error_name, findings.error_unit) = name_and_unit(study.error);
  std::tie(findings.cost_name, findings.cost_unit) = name_and_unit(study.cost);
  for (const StudyAxis& axis : study.axes) findings.axes.push_back(axis.name);
  findings.provenance = build_information();
  findings.provenance.scene_sha256 = study.sha256;
  std::set<std::string> machines;
  for (StudyCase& one : cases) {
    fill_figures(study, one);
    if (!one.clock.machine.empty()) machines.insert(one.clock.machine);
  }
  findings.machines.assign(machines.begin(), machines.end());
  findings.cases = std::move(cases);
  findings.series = series_of(findings.cases);
  for (StudySeries& series : findings.series) take_published(study, findings.cases, series);
  findings.front = pareto_front(findings.cases, &StudyCase::cost);
  findings.work_front = pareto_front(findings.cases, &StudyCase::work);
  for (const std::size_t i : findings.front) findings.cases[i].on_front = true;
  findings.digits = digits_of(findings);
  findings.budget = budget_of(plan, findings.cases);
  findings.expect = judged_of(study, findings);
  findings.warnings = warnings_of(plan, findings);
  if (untimed) findings.warnings.emplace_back("timing: none: what cases cost is counted in particle-steps");
  return findings;
}

std::pair<std::string, std::string> name_and_unit(const std::string& key) {
  const Field figure = figure_of_result(key);
  if (figure.name.empty()) return {key, ""};
  return {figure.name, figure.unit == "1" ? "" : figure.unit};
}

double rounded_power(int k) { return parse_number("1e" + std::to_string(k)).value_or(k < 0 ? 0.0 : HUGE_VAL); }

}  // namespace assay::drivers
