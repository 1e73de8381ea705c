// SPDX-License-Identifier: BSD-3-Clause
// The body force averaged over boxes around points, which `eval` is given.
#pragma once

#include <string>
#include <vector>

#include "drivers/output/point_reader.hpp"
#include "harness/exact/hexahedra.hpp"

namespace assay::drivers {

/// b over the box of a point.
struct BoxForce {
  DomainForce acts;
  double volume = 0;  ///< in the plane of a thickness of 1 m [m^3]
};

/// Throws InputError at a box that is too large or too small for a mean.
void require_boxes(const Motion& motion, const std::vector<ReferencePoint>& points, bool in_space,
                   const std::string& file);

/// Of points that all have a box, in their order. A box that is not small against the motion is divided. density: rho0
/// [kg/m^3]; quasi_static: without inertia.
std::vector<BoxForce> box_forces(const ExactSolution& exact, double density, const std::vector<ReferencePoint>& points,
                                 bool in_space, bool quasi_static = false);

}  // namespace assay::drivers
