// SPDX-License-Identifier: BSD-3-Clause
// Which case of a study to take for an error that is wanted, and which method lives through most.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drivers/study/analysis/findings.hpp"

namespace assay::drivers {

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

  std::string completed_text() const;                                    ///< "3 of 4"
  int asked() const { return completed + died + refused + unfinished; }  ///< cases that apply to it

  ASSAY_FIELDS(method, completed, died, refused, unfinished, not_applicable, uses_exact_solution, error_ratio)
};

/// The best first. Throws InputError where the study has no axis `method`. By the share completed of what applies,
/// fewer deaths, more cases that apply, the smaller ratio of errors. What uses the exact solution stands behind all
/// others.
std::vector<Survival> survivals(const StudyFindings& findings);

/// The first of these, where it completed anything without the exact solution; null where nobody can be recommended.
const Survival* hardiest(const std::vector<Survival>& found);

/// The next power of ten below what a case reaches, as far as the study tells.
struct NextDigit {
  double error = 0;                 ///< the level
  std::optional<std::size_t> best;  ///< the cheapest measured case that meets it; index into cases
  Figure interpolated;              ///< cost between measured resolutions
  Figure factor;                    ///< cost of `best`, or else interpolated, over that of the case
};

/// Indices into StudyFindings::cases. Taken are eligible cases with a cost, never one that uses the exact solution or
/// is there for the error budget alone.
struct Recommendation {
  double error = 0;                      ///< that is wanted
  std::optional<std::size_t> best;       ///< the cheapest that meets it; of equal cost the more accurate
  std::optional<std::size_t> runner_up;  ///< the cheapest that meets it by another method
  bool told_apart = true;                ///< the runner-up's cost is higher beyond noise
  std::optional<std::size_t> nearest;    ///< the most accurate, where none meets it
  std::optional<NextDigit> next;         ///< beyond what `best` reaches; absent where the study has no such level
};

/// Another method: another value on the axis `method`, or another series where there is no such axis.
Recommendation recommended(const StudyFindings& findings, double error);

/// "1e-3", or "1 %" where the study's error has no unit. Throws InputError for anything but a finite number above 0.
double wanted_error(const StudyFindings& findings, const std::string& text);

}  // namespace assay::drivers
