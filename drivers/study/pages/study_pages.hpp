// SPDX-License-Identifier: BSD-3-Clause
// The pages of a study, and the files that it leaves beside its cases.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "drivers/output/report.hpp"
#include "drivers/study/analysis/findings.hpp"
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

}  // namespace assay::drivers
