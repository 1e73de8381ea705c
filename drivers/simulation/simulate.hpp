// SPDX-License-Identifier: BSD-3-Clause
// The time loop of a run: steps, samples of the error, snapshots, accounts.
#pragma once

#include <set>

#include "drivers/result/result.hpp"
#include "drivers/simulation/problem.hpp"
#include "drivers/simulation/snapshots.hpp"
#include "drivers/system/progress.hpp"

namespace assay::drivers {

/// Steps after which the run is looked at; the begin, the end and T/2 are among them.
struct Observations {
  std::set<std::int64_t> samples;   ///< of the error; empty where there is no exact solution to compare with
  std::set<std::int64_t> shots;     ///< snapshots for VTU files and pictures
  std::set<std::int64_t> accounts;  ///< of momentum and energy
};
Observations observations_of(const Problem& problem);

/// Runs the problem to its end, or to the finding that stops it, and fills in the result's outcome, time, errors,
/// profile, work and drift. Throws Interrupted when a signal came.
void simulate(Problem& problem, ExactSolutionPtr exact, Snapshots& snapshots, Progress& progress, Result& result);

/// CPU time of this process [s] and its peak resident memory [bytes].
double cpu_seconds();
std::int64_t peak_memory();

}  // namespace assay::drivers
