// SPDX-License-Identifier: BSD-3-Clause
// The last test of `check`: a vortex from end to end, on a coarse grid.
#pragma once

#include "drivers/material/material_choice.hpp"
#include "harness/check/battery.hpp"

namespace assay::drivers {

inline constexpr const char* vortex_test = "vortex";

/// The error of a whole run with the material against that of neo-Hookean elasticity of the same stiffness at rest:
/// stress, state and batches as a particle code uses them. Not applicable where the vortex is no test of the material.
/// ellipticity: the battery's measure, null where it has none.
check::TestResult end_to_end_vortex(const ResolvedMaterial& material, std::optional<double> ellipticity);

}  // namespace assay::drivers
