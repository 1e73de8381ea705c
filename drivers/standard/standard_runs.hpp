// SPDX-License-Identifier: BSD-3-Clause
// Our own methods on the standard set.
#pragma once

#include "drivers/standard/standard_card.hpp"

namespace assay::drivers {

/// What a method sets in the scene of a problem, "key.path=YAML value".
std::vector<std::string> sets_of(const StandardSet& set, const StandardMethod& method, const StandardProblem& problem);

/// Runs every problem on its grids, each in a process of its own, into OUT/METHOD/ID/h_0.05, and judges the particles
/// that it leaves there. Throws InputError, SystemError, Interrupted.
CardCode run_by(const StandardSet& set, const StandardMethod& method, const std::string& out, bool quiet,
                const std::string& program = "/proc/self/exe");

}  // namespace assay::drivers
