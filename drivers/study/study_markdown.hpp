// SPDX-License-Identifier: BSD-3-Clause
// A study as compact Markdown, for a pull request or a wiki.
#pragma once

#include <string>

#include "drivers/study/findings.hpp"

namespace assay::drivers {

/// The report's answer, tables and warnings without its pictures.
std::string study_markdown(const StudyFindings& findings);

}  // namespace assay::drivers
