// SPDX-License-Identifier: BSD-3-Clause
// A C2 function through given points.
#pragma once

#include <span>
#include <vector>

namespace assay {

/// Cubic spline with not-a-knot ends: cubic polynomials are reproduced, and with fewer than four points the polynomial
/// through all of them.
class CubicSpline {
 public:
  /// Two points at least, x ascending.
  CubicSpline(std::span<const double> x, std::span<const double> y);

  struct Value {
    double value = 0, slope = 0, curvature = 0;
  };
  /// The first and the last cubic go on beyond the ends.
  Value at(double x) const;
  std::span<const double> values() const { return y_; }  ///< at the points

 private:
  std::vector<double> x_, y_, curvature_;  // second derivatives at the points
};

}  // namespace assay
