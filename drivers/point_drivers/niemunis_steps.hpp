// SPDX-License-Identifier: BSD-3-Clause
// Reads one step of a load path of Niemunis' driver.
#pragma once

#include "drivers/point_drivers/niemunis_file.hpp"
#include "drivers/point_drivers/niemunis_lines.hpp"

namespace assay::drivers {

/// The line of its keyword is the present one. The last line of the step is, afterwards.
NiemunisStep read_niemunis_step(NiemunisLines& lines, const std::string& file);

}  // namespace assay::drivers
