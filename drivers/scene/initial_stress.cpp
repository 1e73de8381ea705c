// SPDX-License-Identifier: BSD-3-Clause
// The stress at rest, and under which of these a scene's motion has an exact solution.
#include <cmath>

#include "drivers/scene/scene.hpp"
#include "harness/motion/kinds/axis_aligned.hpp"
#include "harness/motion/kinds/vortex3d.hpp"

namespace assay::drivers {

Tensor Scene::initial_cauchy() const {
  return symmetric_tensor(material.initial_stress.value_or(std::array<double, 6>{}));
}

bool Scene::bears_tractions() const {
  return motion->bears_tractions() || (!initial_cauchy().isZero(0) && body.outside == Body::Outside::free);
}

namespace {

/// sigma0 must be the same at all points, and have the symmetry that the motion's response has.
std::string fault_for_motion(const Scene& scene, const std::array<double, 6>& s) {
  const bool sheared = s[3] != 0 || s[4] != 0 || s[5] != 0;
  if (scene.motion.as<Vortex3d>()) return "is not there yet for vortex3d, whose response begins without stress";
  if (ring_of(scene.motion) && (sheared || s[0] != s[1]))
    return "must have equal components 11 and 22 and no shear: no other stress is the same all around the ring";
  if (scene.motion.as<AxisAligned>() && sheared)
    return "must have no shear: the faces of the unit box are symmetry planes";
  if (scene.dimension == 2 && (s[4] != 0 || s[5] != 0))
    return "must have no shear 13 and 23 in the plane: they need dimension: 3";
  return {};
}

}  // namespace

std::string fault_of_initial_stress(const Scene& scene) {
  if (scene.initial_cauchy().isZero(0)) return {};
  if (std::string fault = fault_for_motion(scene, *scene.material.initial_stress); !fault.empty()) return fault;
  if (!scene.method) return {};
  if (scene.dimension == 2 && scene.frame && scene.body.outside == Body::Outside::free)
    return "would need tractions on a body that is seen from a frame: take body.outside: held";
  return {};
}

}  // namespace assay::drivers
