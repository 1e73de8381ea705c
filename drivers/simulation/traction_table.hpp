// SPDX-License-Identifier: BSD-3-Clause
// The algorithms that bring a traction to the grid, side by side on one motion.
#pragma once

#include "drivers/output/output_folder.hpp"
#include "drivers/result/result.hpp"
#include "drivers/simulation/problem.hpp"

namespace assay::drivers {

/// Whether it is that of section 3 of the paper, on whatever grid. The paper names no density there, and takes
/// 1000 kg/m^3 in section 2.
bool is_table_1(const Problem& problem);

/// Runs the scene again under tractions by every algorithm on grids of 4h, 2h and h, of which those are left out that
/// do not have the body's corners for nodes. `own`: the result of the scene itself, which is not run twice. Each takes
/// the form that the scene gives, else the stable one. Nothing is written to the folder. Throws Interrupted.
TractionTable traction_table(const Problem& problem, const Result& own, OutputFolder& folder, bool quiet);

}  // namespace assay::drivers
