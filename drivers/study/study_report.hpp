// SPDX-License-Identifier: BSD-3-Clause
// report.html of a study: one self-contained page for people; no script, no network.
#pragma once

#include <string>
#include <vector>

#include "drivers/output/report.hpp"
#include "drivers/study/findings.hpp"

namespace assay::drivers {

/// The question and its answer first, then what they rest on, last where it comes from. Links the files of
/// study_tables() beside it.
std::string study_report_html(const StudyFindings& findings, const std::vector<ReportPicture>& pictures);

}  // namespace assay::drivers
