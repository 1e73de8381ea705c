// SPDX-License-Identifier: BSD-3-Clause
// Stress and body force of the axis-aligned motion at single points, each from histories of its own.
#pragma once

#include <span>
#include <vector>

#include "harness/material/material.hpp"
#include "harness/motion/kinds/axis_aligned.hpp"

namespace assay {

/// P and b = a - DIV(P)/rho0 at the reference point X at ascending times > 0. The gradient of P is taken by differences
/// of fourth order between the histories of neighbouring cos(pi X) and cos(pi Y): some 10 digits, fewer where a front
/// runs between them. material_direction: along the axes. Throws MaterialFailure.
std::vector<ExactStress> axis_aligned_stress(const Material& material, const AxisAligned& motion, double density,
                                             const Vector3& X, std::span<const double> times,
                                             const std::array<double, 3>& material_direction);

}  // namespace assay
