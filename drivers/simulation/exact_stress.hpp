// SPDX-License-Identifier: BSD-3-Clause
// Stress and body force of a scene's exact motion at reference points.
#pragma once

#include <memory>
#include <vector>

#include "drivers/output/points_csv.hpp"
#include "drivers/scene/scene.hpp"
#include "harness/exact/exact_fields.hpp"

namespace assay::drivers {

/// Throws InputError where a point's time lies beyond the last row of motion.path, or the point outside a twisting
/// ring.
void require_within_motion(const Scene& scene, const std::vector<ReferencePoint>& points, const std::string& file);

/// One for each point, in their order, of exact_solution_at_points. Throws InputError, MaterialFailure, Interrupted.
/// quiet: no terminal shows how far it is.
std::vector<ExactPoint> exact_points(const Scene& scene, const std::shared_ptr<const Material>& material,
                                     const std::vector<ReferencePoint>& points, double end, bool quiet = true);

}  // namespace assay::drivers
