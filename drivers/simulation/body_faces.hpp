// SPDX-License-Identifier: BSD-3-Clause
// Which faces of a body are symmetry planes of its motion, which are periodic, and which bear tractions.
#pragma once

#include <array>
#include <optional>

#include "drivers/scene/scene.hpp"
#include "mpm/grid/images.hpp"

namespace assay::drivers {

/// Of the motions in the unit box: faces at whole metres, and of the bar those along it, are symmetry planes; others
/// bear tractions. In space so are those across the axis of a vortex in the plane. Periodic ones as body.periodic says.
/// Throws InputError where a plane is no line of the grid, or the body no whole number of periods.
template <int Dim = 2>
std::array<mpm::AxisEnds, Dim> ends_of(const Scene& scene);

/// Throws InputError where the corners of a box are not corners of the particles' domains.
void require_surface(const Scene& scene);

/// On all faces of a body that the motion deforms and whose forces are computed; the form that keeps the exact motion
/// stable where the scene does not say, which is written into it.
std::optional<mpm::Traction> traction_of(Scene& scene);

}  // namespace assay::drivers
