// SPDX-License-Identifier: BSD-3-Clause
// What `assay recommend` and `assay compare` say of stored studies: text of 80 columns, Markdown and JSON.
#pragma once

#include <string>
#include <vector>

#include "drivers/study/analysis/comparison.hpp"
#include "drivers/study/analysis/recommendation.hpp"
#include "drivers/study/analysis/study_json.hpp"

namespace assay::drivers {

/// At most 80 columns, but for commands, which stand on one line each.
std::string recommendation_text(const StoredStudy& study, const Recommendation& found);

/// {error, unit, met, recommended, runner_up, told_apart, nearest, next_digit}; a case is {number, label, values,
/// folder, command, error, cost, cost_unit, cost_spread, threads}. Every key is always present.
std::string recommendation_json(const StoredStudy& study, const Recommendation& found);

/// At most 80 columns, but for the command.
std::string survival_text(const StoredStudy& study, const std::vector<Survival>& found);

/// {recommended, settings, methods}; settings are those of the recommended one; a method is {method, completed, died,
/// refused, unfinished, not_applicable, uses_exact_solution, error_ratio, lost}, one lost is {number, label, outcome,
/// reason}. `recommended` is null where there is no method.
std::string survival_json(const StoredStudy& study, const std::vector<Survival>& found);

/// "NOTHING WORSE: 2 faster, 30 the same", "WORSE: 1 new failure, 3 slower, 28 the same".
std::string comparison_verdict(const Comparison& found);

/// A table of the cases that differ, or of `all`; the cheapest cases, the front, what was expected, warnings; the
/// verdict last.
std::string comparison_text(const StoredStudy& A, const StoredStudy& B, const Comparison& found, bool all = false);

/// The verdict, tables of all cases and of the cheapest, warnings.
std::string comparison_markdown(const StoredStudy& A, const StoredStudy& B, const Comparison& found);

/// {worse, verdict, a, b, cases, digits, front, expectations, warnings, load}; every key is always present, figures
/// that are not there are null.
std::string comparison_json(const StoredStudy& A, const StoredStudy& B, const Comparison& found);

/// After over before, "1.24": as many digits, from three on, as tell a figure that counts as changed from 1; "-".
std::string ratio_text(const ComparedFigure& figure);

}  // namespace assay::drivers
