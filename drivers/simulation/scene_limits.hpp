// SPDX-License-Identifier: BSD-3-Clause
// Whether a scene can be run, and within its limits.
#pragma once

#include "drivers/simulation/problem.hpp"

namespace assay::drivers {

/// Cells around the body: room to go wrong in before the grid's edge.
inline constexpr int grid_margin = 4;

/// Throws InputError at a key of the scene.
[[noreturn]] inline void refuse(const Scene& scene, const std::string& key, const std::string& why,
                                const std::string& known = {}) {
  throw InputError(scene.place(key), key, why, known);
}

/// Throws InputError where the motion has no acceleration at some times.
void require_acceleration(const Scene& scene);

/// Throws InputError where the motion, the method or the body cannot be run.
void require_runnable(const Scene& scene);

/// Before a lattice and a grid are made: throws InputError where their sizes alone are out of all bounds.
void check_sizes(const Scene& scene);

/// Throws InputError where the integrator cannot do with the material's stress.
void require_reversible(const Scene& scene, const Material& material);

/// Throws InputError where memory or particle-steps exceed the scene's limits.
void check_limits(const Problem& problem);

}  // namespace assay::drivers
