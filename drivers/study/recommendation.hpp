// SPDX-License-Identifier: BSD-3-Clause
// Which case of a study to take for an error that is wanted.
#pragma once

#include <optional>
#include <string>

#include "drivers/study/study_file.hpp"

namespace assay::drivers {

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

/// At most 80 columns, but for commands, which stand on one line each.
std::string recommendation_text(const StoredStudy& study, const Recommendation& found);

/// {error, unit, met, recommended, runner_up, told_apart, nearest, next_digit}; a case is {number, label, values,
/// folder, command, error, cost, cost_unit, cost_spread, threads}. Every key is always present.
std::string recommendation_json(const StoredStudy& study, const Recommendation& found);

}  // namespace assay::drivers
