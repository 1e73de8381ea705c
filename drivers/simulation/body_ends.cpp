// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/body_ends.hpp"

#include <cmath>

#include "drivers/scene/body_box.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/text/number_format.hpp"

namespace assay::drivers {

namespace {

constexpr double whole_multiples = 1e-9;  ///< a number this close to a whole one is that one

bool is_whole(double x) { return std::abs(x - std::round(x)) <= whole_multiples; }

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

void require_period(const Scene& scene, std::size_t d, const Box& box) {
  const std::string fault = scene.motion->fault_of_period(d, box.upper[d] - box.lower[d]);
  if (!fault.empty()) throw InputError(scene.place("body.periodic"), "body.periodic", fault);
}

}  // namespace

std::array<mpm::AxisEnds, 2> ends_of(const Scene& scene) {
  std::array<mpm::AxisEnds, 2> ends;
  if (ring_of(scene.motion)) return ends;
  const Box box = body_box(scene);
  for (std::size_t d = 0; d < 2; ++d) {
    if (scene.body.is_periodic(d)) {
      require_period(scene, d, box);
      ends[d] = {box.lower[d], box.upper[d], true};
    } else {
      if (scene.motion->is_symmetry_plane(d, box.lower[d])) ends[d].lower = box.lower[d];
      if (scene.motion->is_symmetry_plane(d, box.upper[d])) ends[d].upper = box.upper[d];
    }
    if (ends[d].lower) require_node(scene, *ends[d].lower, "body.lower");
    if (ends[d].upper) require_node(scene, *ends[d].upper, "body.upper");
  }
  return ends;
}

}  // namespace assay::drivers
