// SPDX-License-Identifier: BSD-3-Clause
// The time loop of a run: steps, samples of the error, snapshots, accounts.
#pragma once

#include "drivers/progress.hpp"
#include "drivers/result.hpp"
#include "drivers/simulation/problem.hpp"
#include "drivers/simulation/snapshots.hpp"

namespace assay::drivers {

/// Runs the problem to its end, or to the finding that stops it, and fills in the result's outcome, time, errors,
/// profile, work and drift. Throws Interrupted when a signal came.
void simulate(Problem& problem, std::shared_ptr<const Response> response, Snapshots& snapshots, Progress& progress,
              Result& result);

/// CPU time of this process [s] and its peak resident memory [bytes].
double cpu_seconds();
std::int64_t peak_memory();

}  // namespace assay::drivers
