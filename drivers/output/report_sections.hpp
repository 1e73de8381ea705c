// SPDX-License-Identifier: BSD-3-Clause
// The sections of report.html that are tables of figures.
#pragma once

#include <string>
#include <vector>

#include "drivers/result/result.hpp"

namespace assay::drivers {

/// The sample with the largest L2 error of the displacement; null without one.
const ErrorSample* worst_displacement(const std::vector<ErrorSample>& history);

/// Seconds and share of each pass, with bars.
std::string profile_table(const std::vector<PassFigures>& passes);

// Each is empty where the run has nothing of it.
std::string errors_section(const Result& result, double period);
std::string tractions_section(const Result& result);
std::string profile_section(const Result& result);
std::string credibility_section(const Result& result);
std::string provenance_section(const Result& result);

}  // namespace assay::drivers
