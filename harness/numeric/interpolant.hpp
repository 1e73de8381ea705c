// SPDX-License-Identifier: BSD-3-Clause
// A function through given points.
#pragma once

#include <span>
#include <vector>

namespace assay {

/// What a function does between its points.
enum class Interpolation {
  linear,    ///< straight lines: continuous, its slope jumps at the points
  monotone,  ///< PCHIP of Fritsch and Carlson: C1, within the values at both ends of an interval
  spline     ///< cubic, with not-a-knot ends: C2, may swing beyond the values
};
constexpr std::array<const char*, 3> names_of(Interpolation) { return {"linear", "monotone", "spline"}; }

/// Cubic on each interval. The spline reproduces cubic polynomials, and is with fewer than four points the polynomial
/// through all of them; the other two reproduce straight lines.
class Interpolant {
 public:
  /// Two points at least, x ascending.
  Interpolant(std::span<const double> x, std::span<const double> y, Interpolation kind);

  struct Value {
    double value = 0, slope = 0, curvature = 0;
  };
  /// At a point the derivatives are those of the interval that begins there. The first and the last cubic go on beyond
  /// the ends.
  Value at(double x) const;
  std::span<const double> values() const { return y_; }  ///< at the points

  /// The farthest that the function goes beyond the two values at the ends of one interval.
  struct Departure {
    double x = 0, value = 0;
    double lower = 0, upper = 0;  ///< the two values, ascending
    double by = 0;                ///< 0: nowhere
  };
  Departure farthest_departure() const;

 private:
  /// y = y_[i] + d (slope + d (curvature / 2 + d third / 6)), d from the beginning of interval i.
  struct Cubic {
    double slope = 0, curvature = 0, third = 0;
  };
  Cubic cubic(std::size_t i) const;
  Value value(std::size_t i, const Cubic& cubic, double d) const;

  Interpolation kind_;
  std::vector<double> x_, y_;
  std::vector<double> shape_;  ///< at the points: second derivatives of a spline, slopes of a monotone function
};

}  // namespace assay
