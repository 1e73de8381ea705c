// SPDX-License-Identifier: BSD-3-Clause
// `expect:` of a study, judged.
#pragma once

#include <vector>

#include "drivers/study/findings.hpp"
#include "drivers/study/study.hpp"

namespace assay::drivers {

/// Each line for every case of its selection, or for every series that has one there. A selection without cases holds
/// nothing.
std::vector<StudyExpectationOutcome> judged_of(const Study& study, const StudyFindings& findings);

}  // namespace assay::drivers
