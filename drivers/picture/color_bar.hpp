// SPDX-License-Identifier: BSD-3-Clause
// The bar beside a picture that says which colour is which value.
#pragma once

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
  double text_size = picture_text_size;
};

/// Room that it takes to the right of `left` [pixel].
double width_of(const ColorBar& bar);

void draw(Canvas& canvas, const ColorBar& bar);

/// Ends of the colours for these values, those that are not finite left out: around 0 if diverging.
std::array<double, 2> color_range(std::span<const double> values, ColorMap map);

}  // namespace assay::drivers
