// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/exact_stress.hpp"

#include <cmath>

#include "drivers/simulation/response_source.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/system/progress.hpp"
#include "drivers/text/number_format.hpp"
#include "harness/motion/kinds/deformation_table.hpp"

namespace assay::drivers {

void require_within_motion(const Scene& scene, const std::vector<ReferencePoint>& points, const std::string& file) {
  constexpr double edge_rounding = 1e-9;  // of a radius: points on the ring's edges are in the ring
  if (const auto ring = ring_of(scene.motion); ring && !is_vortex(scene.motion)) {
    for (const ReferencePoint& point : points) {
      const double R = std::hypot(point.X, point.Y);
      if (R >= ring->inner * (1 - edge_rounding) && R <= ring->outer * (1 + edge_rounding)) continue;
      throw InputError({file, point.line, 1}, "X",
                       "the point is at the radius " + rounded_text(R, 6) + ", outside of the ring between " +
                           rounded_text(ring->inner, 6) + " and " + rounded_text(ring->outer, 6));
    }
  }
  const auto* table = scene.motion.as<DeformationTable>();
  for (const ReferencePoint& point : points) {
    if (!table || point.t <= table->last()) continue;
    throw InputError({file, point.line, 1}, "t",
                     "beyond the last row of motion.path, " + rounded_text(table->last(), 6));
  }
}

std::vector<ExactPoint> exact_points(const Scene& scene, const std::shared_ptr<const Material>& material,
                                     const std::vector<ReferencePoint>& points, double end, bool quiet) {
  std::vector<PlaceAndTime> places;
  for (const ReferencePoint& point : points) places.push_back({{point.X, point.Y, point.Z}, point.t});
  const ExactSolutionPtr exact = exact_solution_at_points(scene, material, end, quiet);
  Progress progress("eval", quiet);
  return exact->at(places, [&](double share, const char* of) {
    stop_if_interrupted();
    progress.update(share, of);
  });
}

}  // namespace assay::drivers
