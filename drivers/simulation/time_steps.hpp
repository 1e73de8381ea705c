// SPDX-License-Identifier: BSD-3-Clause
// How long a run's steps are.
#pragma once

#include "drivers/simulation/problem.hpp"

namespace assay::drivers {

/// Into the problem: the fastest waves on the baseline path, what artificial viscosity makes of them, and the fastest
/// particle of the exact motion, as the scene's frame sees it.
void find_speeds(Problem& problem);

/// What crosses cells of the grid the fastest [m/s]: a wave and the particle that carries it, or, of the total
/// formulation, a wave across the reference configuration, where that is faster.
double fastest_signal(const Problem& problem);

/// By what factor a viscous pressure shortens the stable step, with waves of that speed [m/s] and volumes that shrink
/// at that rate [1/s]: (Q + sqrt(Q^2 + c^2)) / c with Q = C1 c + C2 h |tr D|, of central differences that take the
/// velocity of half a step before (Benson 1992, doi:10.1016/0045-7825(92)90042-I). 1 without viscosity.
double viscous_shortening(const Problem& problem, double wave, double shrinking);

/// The fastest that the exact motion shrinks volumes, -tr D [1/s]; at least 0.
double fastest_shrinking(const Scene& scene);

/// dt and the number of steps, from time.step or the Courant number and both speeds. Throws InputError.
void plan_steps(Problem& problem);

}  // namespace assay::drivers
