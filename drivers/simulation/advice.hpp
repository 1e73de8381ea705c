// SPDX-License-Identifier: BSD-3-Clause
// What a run that died could try.
#pragma once

#include <array>
#include <string>

#include "drivers/simulation/problem.hpp"

namespace assay::drivers {

/// What lives through more of the hard cases (docs/hard.md, bench/results/hard) than the method of this run; empty
/// where nothing does. reason: of which it died.
std::string advice_after_death(const Problem& problem, const std::string& reason = {});

/// Lengths of the body along the axes [m]; zeros without particles.
std::array<double, 2> sides_of_body(const Problem& problem);

}  // namespace assay::drivers
