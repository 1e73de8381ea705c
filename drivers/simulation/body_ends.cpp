// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/body_ends.hpp"

#include <cmath>

#include "drivers/input_error.hpp"
#include "drivers/output/number_format.hpp"
#include "drivers/scene/body_box.hpp"

namespace assay::drivers {

namespace {

constexpr double whole_multiples = 1e-9;  ///< a number this close to a whole one is that one

bool is_whole(double x) { return std::abs(x - std::round(x)) <= whole_multiples; }

/// Whether the motion is its own mirror image at a plane across axis d.
bool is_symmetry_plane(const AxisAligned& motion, std::size_t d, double at) {
  return is_whole(at) || (motion.one_dimensional && d == 1);
}

void require_node(const Scene& scene, double at, const std::string& key) {
  const double h = scene.grid->spacing;
  if (is_whole(at / h)) return;
  throw InputError(
      scene.place("grid.spacing"), "grid.spacing",
      key + " = " + rounded_text(at, 6) +
          " is a symmetry plane or a periodic end, which must lie on a line of the grid: it is no multiple "
          "of " +
          rounded_text(h, 6));
}

/// Of the motions in the box a period is 2 m, across the bar any length.
void require_period(const Scene& scene, std::size_t d, const Box& box) {
  const auto* rigid = std::get_if<Rigid>(&scene.motion);
  if (rigid && rigid->spin != 0) {
    throw InputError(scene.place("body.periodic"), "body.periodic", "a body that spins does not repeat");
  }
  const auto* motion = std::get_if<AxisAligned>(&scene.motion);
  const double width = box.upper[d] - box.lower[d];
  if (!motion || (motion->one_dimensional && d == 1) || is_whole(width / 2)) return;
  throw InputError(scene.place("body.periodic"), "body.periodic",
                   "the motion repeats after 2 m, and the body is " + rounded_text(width, 6) + " m wide");
}

}  // namespace

std::array<mpm::AxisEnds, 2> ends_of(const Scene& scene) {
  std::array<mpm::AxisEnds, 2> ends;
  if (ring_of(scene.motion)) return ends;
  const auto* motion = std::get_if<AxisAligned>(&scene.motion);
  const Box box = body_box(scene);
  for (std::size_t d = 0; d < 2; ++d) {
    if (scene.body.is_periodic(d)) {
      require_period(scene, d, box);
      ends[d] = {box.lower[d], box.upper[d], true};
    } else if (motion) {
      if (is_symmetry_plane(*motion, d, box.lower[d])) ends[d].lower = box.lower[d];
      if (is_symmetry_plane(*motion, d, box.upper[d])) ends[d].upper = box.upper[d];
    }
    if (ends[d].lower) require_node(scene, *ends[d].lower, "body.lower");
    if (ends[d].upper) require_node(scene, *ends[d].upper, "body.upper");
  }
  return ends;
}

}  // namespace assay::drivers
