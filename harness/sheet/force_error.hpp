// SPDX-License-Identifier: BSD-3-Clause
// What the error of a sheet does to the body force that is made of it.
#pragma once

#include "harness/motion/motion.hpp"
#include "harness/sheet/sheet.hpp"

namespace assay {

/// Estimate of the error of b at a point, (32) and (33) with the sheet's stated errors in tau and d tau / d xi, over
/// the largest |b| of the ring until `end`. density: rho0 [kg/m^3].
double force_error(const Motion& motion, double density, const Sheet& sheet, double end);

}  // namespace assay
