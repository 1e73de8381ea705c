// SPDX-License-Identifier: BSD-3-Clause
// Which method of a study lives through its cases.
#pragma once

#include <string>
#include <vector>

#include "drivers/study/study_file.hpp"

namespace assay::drivers {

bool uses_exact_solution(const StudyCase& one);

/// The value on the axis `method`, or the series where there is no such axis.
std::string method_of(const StudyCase& one);

/// How a method went through the cases of a study, those of the error budget not counted.
struct Survival {
  std::string method;
  int completed = 0, refused = 0, not_applicable = 0;
  int died = 0;                      ///< unstable, failed or crashed
  int unfinished = 0;                ///< stopped at the study's limit of time, or not run yet
  bool uses_exact_solution = false;  ///< in all cases that it completed
  std::vector<std::size_t> lost;     ///< died, refused or unfinished; indices into StudyFindings::cases
  Figure error_ratio;                ///< median of its error over the smallest of all methods in the same case

  int asked() const { return completed + died + refused + unfinished; }  ///< cases that apply to it
};

/// The best first. Throws InputError where the study has no axis `method`. By the share completed of what applies,
/// fewer deaths, more cases that apply, the smaller ratio of errors. What uses the exact solution stands behind all
/// others.
std::vector<Survival> survivals(const StudyFindings& findings);

/// The first of these, where it completed anything without the exact solution; null where nobody can be recommended.
const Survival* hardiest(const std::vector<Survival>& found);

/// What their ratio of errors is, for readers.
inline constexpr const char* ratio_note =
    "the error of the method divided by the smallest error of any method, as the median over the cases that it "
    "completes. A case that is n/a does not count as completed";

/// Which methods have cases that did not end, and how many; empty where all did.
std::string unfinished_note(const std::vector<Survival>& found);

/// A line each, at most 80 columns.
std::string survival_table(const std::vector<Survival>& found);

/// At most 80 columns, but for the command.
std::string survival_text(const StoredStudy& study, const std::vector<Survival>& found);

/// {recommended, settings, methods}; settings are those of the recommended one; a method is {method, completed, died,
/// refused, unfinished, not_applicable, uses_exact_solution, error_ratio, lost}, one lost is {number, label, outcome,
/// reason}. `recommended` is null where there is no method.
std::string survival_json(const StoredStudy& study, const std::vector<Survival>& found);

}  // namespace assay::drivers
