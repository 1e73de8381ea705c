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

/// What makes the errors smaller of a run that has completed with errors larger than its motion; empty for others.
/// `relative`: the largest error over the largest displacement.
std::string advice_after_large_error(const Problem& problem, double relative);

/// Lengths of the body along the axes [m]; zeros without particles.
std::array<double, 2> sides_of_body(const Problem& problem);

}  // namespace assay::drivers
