// SPDX-License-Identifier: BSD-3-Clause
// Where a scene's response tau(xi, t) comes from: the material's closed form, a sheet from disk, a new one.
#pragma once

#include <memory>

#include "drivers/scene/scene.hpp"
#include "harness/exact/exact_fields.hpp"

namespace assay::drivers {

/// How a response is made.
struct ResponseMaking {
  int threads = 1;
  bool marching = false;  ///< times are asked for in ascending order
  bool quiet = true;      ///< nothing is said of how far it is
};

/// The response that the scene asks for, over times 0 .. end. Shadow points only where times ascend; else a sheet
/// stands in. Throws InputError (no closed form), MaterialFailure, Interrupted.
std::shared_ptr<const Response> response_of(const Scene& scene, const std::shared_ptr<const Material>& material,
                                            const Path& path, double end, const ResponseMaking& how = {});

/// The scene's motion with the stress of its material, over times 0 .. end; the rest as above.
ExactSolutionPtr exact_solution_of(const Scene& scene, const std::shared_ptr<const Material>& material, double end,
                                   const ResponseMaking& how = {});

/// The same for single points at any times, as the scene's frame sees them: each as exact as it can be. The unit box
/// has histories around each point. A motion whose F is the same everywhere has one on its own path, xi =
/// own_parameter(), unless a closed form is asked for.
ExactSolutionPtr exact_solution_at_points(const Scene& scene, const std::shared_ptr<const Material>& material,
                                          double end, bool quiet);

}  // namespace assay::drivers
