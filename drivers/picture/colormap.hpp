// SPDX-License-Identifier: BSD-3-Clause
// Colours that order values: perceptually uniform and readable by the colour-blind.
#pragma once

#include "drivers/picture/canvas.hpp"

namespace assay::drivers {

enum class ColorMap {
  viridis,    ///< dark to light, for magnitudes
  diverging,  ///< blue, near-white, red, for signed values around zero
};

/// Colour at s in [0,1], clamped; grey where s is not a number.
Color map_color(ColorMap map, double s);

inline constexpr Color no_value = rgb(0xb8b8b8);

/// Okabe and Ito's palette, ordered so that neighbours differ also in lightness; repeats after 7.
Color series_color(std::size_t index);

/// The same hues dark enough for text on white (contrast 4.5 and more).
Color series_text_color(std::size_t index);

/// Black or white, whichever is read better on that colour: contrast 4.5 and more (WCAG 2).
Color readable_on(Color background);

/// Relative luminance (WCAG 2): 0 black, 1 white.
double luminance(Color color);

}  // namespace assay::drivers
