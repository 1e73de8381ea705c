// SPDX-License-Identifier: BSD-3-Clause
// How long a run's steps are.
#pragma once

#include "drivers/simulation/problem.hpp"

namespace assay::drivers {

/// The fastest particle of the exact motion, as the scene's frame sees it [m/s].
double fastest_particle(const Problem& problem);

/// What crosses cells of the grid the fastest [m/s]: a wave and the particle that carries it, or, of the total
/// formulation, a wave across the reference configuration, where that is faster.
double fastest_signal(const Problem& problem);

/// dt and the number of steps, from time.step or the Courant number and both speeds. Throws InputError.
void plan_steps(Problem& problem);

}  // namespace assay::drivers
