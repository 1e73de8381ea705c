// SPDX-License-Identifier: BSD-3-Clause
// What a study says on the terminal: at most 80 columns.
#pragma once

#include <string>

#include "drivers/study/findings.hpp"

namespace assay::drivers {

/// One line for a case that has ended: " 3/40  completed  1.2 %  0.35 s  CPDI, grid.spacing=0.05".
std::string case_line(const StudyFindings& words, const StudyCase& one, std::size_t done, std::size_t total);

/// The verdict and the expectations that fail: what a study that ends with 1 says even with --quiet.
std::string contradiction_text(const StudyFindings& findings);

/// The answer first: what each digit costs and by which case, the front, the orders, what was expected; then where the
/// results lie.
std::string study_text(const StudyFindings& findings, const std::string& folder);

}  // namespace assay::drivers
