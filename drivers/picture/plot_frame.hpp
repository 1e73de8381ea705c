// SPDX-License-Identifier: BSD-3-Clause
// The rectangle of a plot between its axes.
#pragma once

#include "drivers/picture/canvas.hpp"
#include "drivers/picture/ticks.hpp"

namespace assay::drivers {

struct PlotFrame {
  double left = 0, top = 0, right = 0, bottom = 0;
  Axis x, y;
  /// Where the value (u, v) is drawn.
  Point at(double u, double v) const {
    return {left + (right - left) * x.fraction(u), bottom - (bottom - top) * y.fraction(v)};
  }
};

}  // namespace assay::drivers
