// SPDX-License-Identifier: BSD-3-Clause
// Whether a law of the total deformation gives work around closed paths in the space of strains.
#pragma once

#include <vector>

#include "harness/check/specimen.hpp"

namespace assay::check {

/// Into a result that has passed: a failure, or a remark where the stress has no potential and is of a kind in common
/// use. times: of the whole path [s]. Laws in increments have the limit of those: none of them stores energy exactly.
void judge_potential(const Specimen& specimen, const std::vector<double>& times, TestResult& result);

}  // namespace assay::check
