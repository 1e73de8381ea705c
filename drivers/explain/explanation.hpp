// SPDX-License-Identifier: BSD-3-Clause
// What `assay explain` prints.
#pragma once

#include <string>

#include "drivers/result/result.hpp"
#include "drivers/simulation/problem.hpp"
#include "harness/exact/exact_fields.hpp"

namespace assay::drivers {

/// Passes, columns, observers, memory, steps, response and stability of a problem, as text or as JSON. Without an exact
/// solution, which is not made where the run is refused, there is no response.
std::string explanation(const Problem& problem, const ExactSolution* exact, const ScreenFigures& screen, bool json);

}  // namespace assay::drivers
