// SPDX-License-Identifier: BSD-3-Clause
// The comparison of two studies as text of 80 columns, Markdown and JSON.
#pragma once

#include <string>
#include <vector>

#include "drivers/study/comparison.hpp"
#include "drivers/study/study_file.hpp"

namespace assay::drivers {

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

/// "NEW FAILURE", "unstable"; "slower", "less accurate"; "same": what is said of a case, a line each.
std::vector<std::string> words_of(const ComparedCase& one);

/// After over before, "1.24": as many digits, from three on, as tell a figure that counts as changed from 1; "-".
std::string ratio_text(const ComparedFigure& figure);

/// The smallest difference of cost that counts, "6 %"; "25 %(1 run)"; "-".
std::string noise_text(const ComparedCase& one);

}  // namespace assay::drivers
