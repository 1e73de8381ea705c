// SPDX-License-Identifier: BSD-3-Clause
// Which faces of a box are symmetry planes of its motion, and which are periodic.
#pragma once

#include <array>

#include "drivers/scene/scene.hpp"
#include "mpm/grid/images.hpp"

namespace assay::drivers {

/// Of the motions in the unit box: faces at whole metres, and of the bar those along it, are symmetry planes; others
/// bear tractions. Periodic ones as body.periodic says. Throws InputError where a plane is no line of the grid, or the
/// body no whole number of periods.
std::array<mpm::AxisEnds, 2> ends_of(const Scene& scene);

}  // namespace assay::drivers
