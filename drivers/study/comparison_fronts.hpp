// SPDX-License-Identifier: BSD-3-Clause
// Whether the best of two studies are the same cases.
#pragma once

#include "drivers/study/comparison.hpp"

namespace assay::drivers {

/// Fills in `digits`, `entered` and `left` of a comparison whose cases are matched.
void compare_fronts(const StudyFindings& A, const StudyFindings& B, Comparison& found);

}  // namespace assay::drivers
