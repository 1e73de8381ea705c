// SPDX-License-Identifier: BSD-3-Clause
// Where an axis is marked, what is written there, and the frame of a plot between two axes.
#pragma once

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "drivers/picture/canvas.hpp"

namespace assay::drivers {

struct Axis {
  double low = 0, high = 1;  ///< ends; low < high, both > 0 where logarithmic
  bool logarithmic = false;
  std::vector<double> major, minor;
  std::vector<std::string> labels;  ///< of the major marks, with ^{..}
  std::string factor;               ///< "×10^{-3}" where the labels are to be multiplied, else empty
  /// 0 at low, 1 at high.
  double fraction(double value) const;
  /// The axis's label, with the factor where there is one.
  std::string titled(const std::string& label) const;
  /// Width of the widest of the marks' labels [pixel].
  double widest_label(double size) const;
};

/// From the least to the largest of values.
struct Extent {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  bool empty() const { return !(low <= high); }
};

/// The rectangle of a plot between its axes.
struct PlotFrame {
  double left = 0, top = 0, right = 0, bottom = 0;
  Axis x, y;
  /// Where the value (u, v) is drawn.
  Point at(double u, double v) const {
    return {left + (right - left) * x.fraction(u), bottom - (bottom - top) * y.fraction(v)};
  }
};

/// How far the ends go beyond the data.
enum class Fit {
  tight,    ///< not at all
  rounded,  ///< to the next mark
};

/// An axis for finite data in [low, high] (positive where logarithmic) with about `target` marks at 1, 2, 5 times
/// powers of ten; a single value gets room on both sides.
Axis make_axis(double low, double high, bool logarithmic, Fit fit, int target = 6);

}  // namespace assay::drivers
