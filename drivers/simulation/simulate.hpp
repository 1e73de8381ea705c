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
Observations observations_of(const PosedScene& problem);

/// Runs the problem to its end, or to the finding that stops it, and fills in the result's outcome, time, errors,
/// profile, work and drift. Throws Interrupted when a signal came.
template <int Dim>
void simulate(ProblemIn<Dim>& problem, const ExactSolutionPtr& exact, Snapshots<Dim>& snapshots, Progress& progress,
              Result& result);

/// CPU time of this process [s] and its peak resident memory [bytes].
double cpu_seconds();
std::int64_t peak_memory();

// The algorithms that bring a traction to the grid, side by side on one motion.

/// Whether it is that of section 3 of the paper, on whatever grid. The paper names no density there, and takes
/// 1000 kg/m^3 in section 2.
bool is_table_1(const PosedScene& problem);

/// Runs the scene again under tractions by every algorithm on grids of 4h, 2h and h, of which those are left out that
/// do not have the body's corners for nodes. `own`: the result of the scene itself, which is not run twice. Each takes
/// the form that the scene gives, else the stable one. Nothing is written to the folder. Throws Interrupted.
template <int Dim>
TractionTable traction_table(const ProblemIn<Dim>& problem, const Result& own, OutputFolder& folder, bool quiet);

}  // namespace assay::drivers
