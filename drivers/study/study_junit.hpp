// SPDX-License-Identifier: BSD-3-Clause
// A study for continuous integration.
#pragma once

#include <string>

#include "drivers/study/findings.hpp"

namespace assay::drivers {

/// JUnit's XML: a test a case, and one an expectation. What a case finds, an early death too, is a finding: only a case
/// that is missing, crashed or stopped fails; one that cannot be is skipped.
std::string study_junit(const StudyFindings& findings);

}  // namespace assay::drivers
