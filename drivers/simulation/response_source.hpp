// SPDX-License-Identifier: BSD-3-Clause
// Where a scene's response tau(xi, t) comes from: the material's closed form, a sheet from disk, a new one.
#pragma once

#include <memory>

#include "drivers/scene/scene.hpp"
#include "harness/exact_solution.hpp"

namespace assay::drivers {

/// The response that the scene asks for, over times 0 .. end, made on that many threads. Shadow points only for whom
/// asks for times in ascending order (`marching`); for others a sheet stands in. Throws InputError (no closed
/// form), MaterialFailure, Interrupted.
std::shared_ptr<const Response> response_of(const Scene& scene, const std::shared_ptr<const Material>& material,
                                            const Path& path, double end, int threads = 1, bool marching = false);

/// The scene's motion with the stress of its material, over times 0 .. end; the rest as above.
std::shared_ptr<const ExactSolution> exact_solution_of(const Scene& scene,
                                                       const std::shared_ptr<const Material>& material, double end,
                                                       int threads = 1);

}  // namespace assay::drivers
