// SPDX-License-Identifier: BSD-3-Clause
// What pictures of coloured values have around them: the axes of a panel, and the bar that says which colour is which
// value.
#pragma once

#include <functional>
#include <string>

#include "drivers/picture/colormap.hpp"
#include "drivers/picture/ticks.hpp"

namespace assay::drivers {

/// Of pictures that are no drawings: what has a light page whatever the reader's is.
inline constexpr Color ink = rgb(0x1a1a1a), axis_color = rgb(0x4d4d4d), paper = rgb(0xffffff);
inline constexpr double picture_text_size = 17;  ///< [pixel]

struct ColorBar {
  ColorMap map = ColorMap::viridis;
  Axis axis;
  std::string label;                     ///< with its unit
  double left = 0, top = 0, bottom = 0;  ///< [pixel]

  /// Room that it takes to the right of `left` [pixel].
  double width() const;
  /// Grey where the value is not finite.
  Color color_of(double value) const;
};

void draw(Canvas& canvas, const ColorBar& bar);

/// Ends of the colours for these values, those that are not finite left out: around 0 if diverging.
std::array<double, 2> color_range(std::span<const double> values, ColorMap map);

/// The axes of a rectangle.
struct PanelAxes {
  double left = 0, top = 0, right = 0, bottom = 0;  ///< [pixel]
  Axis x, y;
  std::string x_title, y_title;
  double title_below = 52;                  ///< of x, from the rectangle to the baseline [pixel]
  std::function<Point(double, double)> at;  ///< where a value is drawn
  bool names_y = true;                      ///< else y has marks alone
};

void draw(Canvas& canvas, const PanelAxes& axes);

}  // namespace assay::drivers
