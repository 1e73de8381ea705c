// SPDX-License-Identifier: BSD-3-Clause
// Pictures of a tabulated response: the sheet as colours, and histories of single xi.
#pragma once

#include "drivers/picture/heat_map.hpp"
#include "drivers/picture/line_plot.hpp"
#include "drivers/tabulation/tabulation.hpp"

namespace assay::drivers {

/// A component of tau, row-major: 12 in simple shear, else the one that becomes largest over the sheet.
int shown_component(const Tabulation& tab);

/// That component over t and xi, lines where its slope in xi jumps (the fronts of a material with kinks), dashes where
/// the path turns.
HeatMap sheet_picture(const Tabulation& tab);

/// That component along four histories xi: over gamma in simple shear, over eps on another straight path, else over t.
LinePlot histories_plot(const Tabulation& tab);

}  // namespace assay::drivers
