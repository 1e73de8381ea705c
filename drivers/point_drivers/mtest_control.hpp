// SPDX-License-Identifier: BSD-3-Clause
// What a file of MTest prescribes, as the point driver takes it; and its names of what is found.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drivers/point_drivers/mtest_file.hpp"
#include "harness/control/controlled_history.hpp"
#include "harness/material/material.hpp"

namespace assay::drivers {

/// Of a material with this state at rest; the file must outlive it. Throws InputError: what cannot be served.
Control mtest_control(const MtestFile& file, const Material& material);

/// The value that the file calls so, at a row: a component of strain, F or stress with MTest's factors, an internal
/// variable, an external one. Nothing where there is none.
std::optional<double> mtest_value(const MtestFile& file, const Material& material, const std::string& name,
                                  const ControlledRow& row);

}  // namespace assay::drivers
