// SPDX-License-Identifier: BSD-3-Clause
// Whether an error that should be rounding grows exponentially: the mark of an unstable form of a traction.
#pragma once

#include <string>

#include "drivers/result/result.hpp"
#include "drivers/simulation/problem.hpp"

namespace assay::drivers {

/// The longest stretch of the history over which ln(L2 error of u) is a straight line in time and the error grows by a
/// factor of 1000 or more; absent where there is none.
std::optional<GrowthFigures> growth_of(const std::vector<ErrorSample>& history);

/// What to do about it, for a motion under tractions.
std::string growth_sentence(const GrowthFigures& growth, const Problem& problem);

}  // namespace assay::drivers
