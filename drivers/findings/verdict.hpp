// SPDX-License-Identifier: BSD-3-Clause
// What a run says on the terminal when it is done: at most 80 columns.
#pragma once

#include <string>

#include "drivers/result/result.hpp"

namespace assay::drivers {

/// Outcome and verdict, expectations that fail, the reason; then error figures, speed, [the profile,] expectations that
/// hold, and where the results are.
std::string verdict_text(const Result& result, const std::string& folder, bool with_profile = false);

/// The first part of it, down to the reason: what a run that ends with 1 says even with --quiet.
std::string contradiction_text(const Result& result);

/// Warnings, and the files in the result's folder that tell more of the material.
std::string process_lines(const Result& result, const std::string& folder);

/// How long it has taken: set-up, the work, and what came behind it.
std::string times_text(const Result& result, const std::string& work);

/// Size, time and errors of the response, and what was asked where that is missed.
std::string sheet_text(const SheetFigures& sheet);

/// The expectations that hold or that fail, a line each, "holds" or "FAILS" first.
std::string expectations_text(const Result& result, bool that_hold);

}  // namespace assay::drivers
