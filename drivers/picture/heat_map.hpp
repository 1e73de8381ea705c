// SPDX-License-Identifier: BSD-3-Clause
// A value over two coordinates as colours, with lines on top.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "drivers/picture/colormap.hpp"

namespace assay::drivers {

struct HeatMap {
  std::string title, x_label, y_label;
  std::string value_label;  ///< with its unit
  ColorMap map = ColorMap::diverging;
  std::array<double, 2> x{0, 1}, y{0, 1};  ///< ends of the axes; the cells divide them evenly
  std::size_t columns = 0, rows = 0;
  std::vector<double> values;                     ///< [column * rows + row]; what is not finite is drawn grey
  std::vector<std::vector<Point>> lines, dashes;  ///< in the coordinates of the axes, drawn full and dashed
};

/// A PNG file, about 900 x 620 pixels. Throws std::invalid_argument where the number of values does not fit.
std::string png(const HeatMap& map);

}  // namespace assay::drivers
