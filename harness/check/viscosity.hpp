// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "harness/check/specimen.hpp"

namespace assay::check {

/// A part of `dissipation`: of a model without memory, what motion adds to its stress takes work, whichever way the
/// body moves. Viscosity of one sign in compression and another in extension gives back in a cycle what it took, so
/// that no cycle shows it. times: over which a strain of 1 goes [s]. Nothing where that holds, or the model is another.
std::optional<TestResult> viscosity(const Specimen& specimen, const std::vector<double>& times);

}  // namespace assay::check
