// SPDX-License-Identifier: BSD-3-Clause
// The pages of a study, the files that it leaves beside its cases, and what is said of it later.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "drivers/output/report.hpp"
#include "drivers/study/analysis/comparison.hpp"
#include "drivers/study/analysis/recommendation.hpp"
#include "drivers/study/analysis/study_json.hpp"
#include "drivers/study/run/case_store.hpp"

namespace assay::drivers {

/// The terminal, at most 80 columns. The answer first: what each digit costs and by which case, the front, the orders,
/// what was expected; then where the results lie.
std::string study_text(const StudyFindings& findings, const std::string& folder);

/// The verdict and the expectations that fail: what a study that ends with 1 says even with --quiet.
std::string contradiction_text(const StudyFindings& findings);

/// One line for a case that has ended: " 3/40  completed  1.2 %  0.35 s  CPDI, grid.spacing=0.05".
std::string case_line(const StudyFindings& words, const StudyCase& one, std::size_t done, std::size_t total);

/// Compact Markdown, for a pull request or a wiki: the report's answer, tables and warnings without its pictures.
std::string study_markdown(const StudyFindings& findings);

/// report.html, one self-contained page for people; no script, no network. The question and its answer first, then what
/// they rest on, last where it comes from. Links the files of study_tables() beside it.
std::string study_report_html(const StudyFindings& findings, const std::vector<ReportPicture>& pictures);

/// The data of every figure as CSV: name of the file to its text. The same on every machine and in every run:
/// cases.csv, orders.csv, histories.csv, budget.csv, stability.csv. Of clocks: timing.csv, work_precision.csv,
/// pareto.csv, digits.csv, passes.csv.
std::map<std::string, std::string> study_tables(const StudyFindings& findings);

/// JUnit's XML: a test a case, and one an expectation. What a case finds, an early death too, is a finding: only a case
/// that is missing, crashed or stopped fails; one that cannot be is skipped.
std::string study_junit(const StudyFindings& findings);

/// The names of all files, as OutputFolder takes them.
std::vector<std::string> study_file_names();

/// Report, tables and pictures, all or none. Throws SystemError.
void write_study(const StudyFindings& findings, const CaseStore& store, const std::filesystem::path& folder);

// What `assay recommend` and `assay compare` say of stored studies: text of 80 columns, Markdown and JSON.

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
