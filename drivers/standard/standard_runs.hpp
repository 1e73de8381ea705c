// SPDX-License-Identifier: BSD-3-Clause
// Our own methods on the standard set.
#pragma once

#include "drivers/standard/standard_card.hpp"

namespace assay::drivers {

/// Runs every problem on its grids, each in a process of its own, into OUT/METHOD/ID/h_0.05, and judges the particles
/// that it leaves there. A problem in space is left out. Throws InputError, SystemError, Interrupted.
CardCode run_by(const StandardSet& set, const StandardMethod& method, const std::string& out, bool quiet,
                const std::string& program = "/proc/self/exe");

}  // namespace assay::drivers
