// SPDX-License-Identifier: BSD-3-Clause
// The data of every figure of a study, as CSV.
#pragma once

#include <map>
#include <string>

#include "drivers/study/findings.hpp"

namespace assay::drivers {

/// Name of the file to its text. The same on every machine and in every run: cases.csv, orders.csv, histories.csv,
/// budget.csv, stability.csv. Of clocks: timing.csv, work_precision.csv, pareto.csv, digits.csv, passes.csv.
std::map<std::string, std::string> study_tables(const StudyFindings& findings);

}  // namespace assay::drivers
