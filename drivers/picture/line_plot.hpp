// SPDX-License-Identifier: BSD-3-Clause
// Curves over an axis, as inline SVG for the report and as PNG beside the numbers.
#pragma once

#include <string>
#include <vector>

#include "drivers/picture/drawing.hpp"

namespace assay::drivers {

struct Series {
  std::string name;  ///< in the legend; empty: not listed
  std::vector<double> x, y;
  bool line = true, markers = false, dashed = false;
};

/// Points that are not finite, or not positive on a logarithmic axis, are left out and interrupt the line.
/// Texts are UTF-8 with ^{..} raised and _{..} lowered.
struct LinePlot {
  std::string title, x_label, y_label;
  bool log_x = false, log_y = false;
  std::vector<Series> series;
};

Drawing draw(const LinePlot& plot);

/// An inline <svg> element, see svg_text().
std::string svg(const LinePlot& plot);

/// A PNG file of 600 by about 400 units at `scale` pixels a unit.
std::string png(const LinePlot& plot, double scale = 2);

}  // namespace assay::drivers
