// SPDX-License-Identifier: BSD-3-Clause
// Where an axis is marked and what is written there.
#pragma once

#include <string>
#include <vector>

namespace assay::drivers {

struct Axis {
  double low = 0, high = 1;  ///< ends; low < high, both > 0 where logarithmic
  bool logarithmic = false;
  std::vector<double> major, minor;
  std::vector<std::string> labels;  ///< of the major marks, with ^{..}
  std::string factor;               ///< "×10^{-3}" where the labels are to be multiplied, else empty
  /// 0 at low, 1 at high.
  double fraction(double value) const;
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
