// SPDX-License-Identifier: BSD-3-Clause
// Pictures in the units of their author: what is labelled in SI, converted before it is drawn.
#pragma once

#include "drivers/picture/line_plot.hpp"
#include "drivers/picture/value_pictures.hpp"
#include "drivers/text/units.hpp"

namespace assay::drivers {

/// The unit of an axis or of values is that in brackets at the end of its label; without brackets they stay.
LinePlot in_units(LinePlot plot, const Units& units);
HeatMap in_units(HeatMap map, const Units& units);
ParticlePicture in_units(ParticlePicture picture, const Units& units);

}  // namespace assay::drivers
