// SPDX-License-Identifier: BSD-3-Clause
// What all runs together say: orders, expectations, and the verdict.
#include <fmt/core.h>

#include <algorithm>

#include "drivers/judge/judge_findings.hpp"
#include "drivers/result/result_json.hpp"
#include "drivers/scene/expect.hpp"
#include "drivers/text/numbers.hpp"
#include "harness/numeric/convergence.hpp"

namespace assay::drivers {

namespace {

FlatValue figure_for(const JudgeFindings& findings, const std::string& key) {
  const auto of = [](const Figure& value) { return value ? FlatValue(*value) : FlatValue(); };
  if (key == order_key) return of(findings.order);
  if (key == last_order_key) return of(findings.last_order);
  if (findings.runs.empty()) return {};
  Result finest;
  finest.error = findings.runs.back().error;
  const auto all = flatten(finest);
  const auto found = all.find(key);
  return found == all.end() ? FlatValue() : found->second;
}

constexpr const char* beyond_sight =
    "the errors cannot be measured: each particle was taken for the nearest one, and they are as large as the distance "
    "between particles lets them look. Write ids or reference positions";

constexpr double falling = 0.5, no_error = 1e-9;  ///< an order; an error over the displacement

std::string percent(double share) { return shortened(fmt::format("{:.0f}", 100 * share), 3) + " %"; }

/// Where the stress is as wrong on a finer grid. A motion may be right with the stress of another material.
std::string stress_that_stays(const std::vector<JudgedGrid>& runs) {
  constexpr double wrong = 0.25, same = 0.95;  // over the scene's; over what it is on the coarser grid
  if (runs.size() < 2) return {};
  const Figure before = runs[runs.size() - 2].relative_stress, after = runs.back().relative_stress;
  if (!before || !after || *after < wrong || *after < same * *before) return {};
  return "the error of the stress does not fall on finer grids: " + percent(*before) + " and " + percent(*after) +
         " of the scene's. Another material, or another measure of stress?";
}

/// What else makes the runs doubtful; empty: nothing.
std::string doubt_of(const JudgeFindings& findings) {
  constexpr double as_large = 0.5;  // of the displacement
  if (findings.runs.empty()) return {};
  const auto unmeasured = std::ranges::find(findings.runs, 0, &JudgedGrid::measured);
  if (unmeasured != findings.runs.end())
    return "nothing is measured: no particle of " + unmeasured->name +
           " lies where the scene's body moves. Another unit of length, another origin, another scene?";
  if (findings.runs.back().is_beyond_sight) return beyond_sight;
  if (starts_otherwise(findings))
    return "the velocities at t = 0 are off by " + percent(*findings.runs.back().start) +
           " of the scene's: another scene, or another initial velocity?";
  const Figure relative = findings.runs.back().error.relative;
  if (relative && *relative > as_large)
    return "the error is " + percent(*relative) +
           " of the motion itself: another scene, a body that does not move, or one axis in another unit?";
  if (findings.last_order && *findings.last_order < falling && relative && *relative > no_error)
    return "the error does not fall on finer grids: order " + rounded_text(*findings.last_order, 3);
  return stress_that_stays(findings.runs);
}

}  // namespace

bool starts_otherwise(const JudgeFindings& findings) {
  constexpr double off = 0.1;
  return !findings.runs.empty() && findings.runs.back().start.value_or(0) > off;
}

void conclude(JudgeFindings& findings, const std::vector<Expectation>& expected) {
  std::vector<double> h, error;
  for (const JudgedGrid& grid : findings.runs) {
    if (grid.h && grid.error.l2_max) h.push_back(*grid.h), error.push_back(*grid.error.l2_max);
  }
  const bool measured = std::ranges::none_of(findings.runs, &JudgedGrid::is_beyond_sight);
  if (const auto fit = measured ? fitted_order(h, error) : std::nullopt) {
    findings.order = fit->order;
    if (fit->lower) findings.order_lower = *fit->lower;
    if (fit->upper) findings.order_upper = *fit->upper;
    const auto pairs = pairwise_orders(h, error);
    if (!pairs.empty() && pairs.back()) findings.last_order = *pairs.back();
    if (h.size() > 2) findings.range = asymptotic_range(h, error).sentence;
  }
  std::vector<std::string> causes;
  std::int64_t lost = 0;
  for (const JudgedGrid& grid : findings.runs) {
    for (const LabelFigures& label : grid.labels) {
      if (std::ranges::find(causes, label.cause) == causes.end()) causes.push_back(label.cause);
    }
    lost += grid.lost + grid.doubled + grid.unknown + grid.not_numbers;
  }
  std::string fails;
  for (const Expectation& line : expected) {
    findings.expect.push_back(judged(line, figure_for(findings, line.key)));
    const ExpectationOutcome& outcome = findings.expect.back();
    if (outcome.holds) continue;
    const std::string found = outcome.found == "null" ? "none" : shortened(outcome.found, 3);
    fails += (fails.empty() ? "" : "; ") + line.key + " " + found + ", expected " + outcome.expected;
  }
  const std::string doubt = doubt_of(findings);
  const CodeFindings& code = findings.code_findings;
  findings.good = causes.empty() && lost == 0 && fails.empty() && doubt.empty() && !code.is_wrong();
  const bool unseen = !findings.runs.empty() && findings.runs.back().is_beyond_sight;
  const std::string of_code = code.is_wrong() ? "a mistake in the code: " + code.sentence : "";
  findings.verdict =
      !causes.empty()
          ? "mistakes in the data: " + joined(causes) + (of_code.empty() ? "" : ". Without them: " + of_code)
      : code.is_wrong() ? of_code
      : unseen          ? doubt
      : lost > 0        ? "particles are lost, doubled or no numbers"
      : !doubt.empty()  ? doubt
      : !fails.empty()  ? fails
      : !findings.last_order
          ? "nothing is wrong with the data"
          : "nothing is wrong; order " + rounded_text(*findings.last_order, 3) + " between the two finest grids";
}

}  // namespace assay::drivers
