// SPDX-License-Identifier: BSD-3-Clause
#include "harness/numeric/interpolant.hpp"

#include <algorithm>
#include <cmath>

namespace assay {

namespace {

/// y'' of the parabola through three points.
double parabola_curvature(std::span<const double> x, std::span<const double> y) {
  const double left = (y[1] - y[0]) / (x[1] - x[0]), right = (y[2] - y[1]) / (x[2] - x[1]);
  return 2 * (right - left) / (x[2] - x[0]);
}

/// Second derivatives M of the spline: h0 M0 + 2 (h0 + h1) M1 + h1 M2 = 6 (slope1 - slope0) at each inner point, and
/// the third derivative continuous at the second and the last but one, which gives M0 and Mn by their neighbours.
std::vector<double> not_a_knot(std::span<const double> x, std::span<const double> y) {
  const std::size_t n = x.size(), inner = n - 2;
  const auto h = [&](std::size_t i) { return x[i + 1] - x[i]; };
  std::vector<double> below(inner), middle(inner), above(inner), right(inner);
  for (std::size_t k = 0; k < inner; ++k) {
    below[k] = h(k), middle[k] = 2 * (h(k) + h(k + 1)), above[k] = h(k + 1);
    right[k] = 6 * ((y[k + 2] - y[k + 1]) / h(k + 1) - (y[k + 1] - y[k]) / h(k));
  }
  const double first = h(0) / h(1), last = h(n - 2) / h(n - 3);
  middle[0] += below[0] * (1 + first), above[0] -= below[0] * first;
  middle[inner - 1] += above[inner - 1] * (1 + last), below[inner - 1] -= above[inner - 1] * last;
  for (std::size_t k = 1; k < inner; ++k) {
    const double factor = below[k] / middle[k - 1];
    middle[k] -= factor * above[k - 1], right[k] -= factor * right[k - 1];
  }
  std::vector<double> M(n);
  for (std::size_t k = inner; k-- > 0;) M[k + 1] = (right[k] - (k + 1 < inner ? above[k] * M[k + 2] : 0)) / middle[k];
  M[0] = (1 + first) * M[1] - first * M[2];
  M[n - 1] = (1 + last) * M[n - 2] - last * M[n - 3];
  return M;
}

std::vector<double> curvatures(std::span<const double> x, std::span<const double> y) {
  if (x.size() >= 4) return not_a_knot(x, y);
  return std::vector<double>(x.size(), x.size() == 3 ? parabola_curvature(x, y) : 0.0);
}

/// At an end: of the parabola through three points, kept within what the first chord allows.
double end_slope(double h, double beyond, double chord, double chord_beyond) {
  const double slope = ((2 * h + beyond) * chord - h * chord_beyond) / (h + beyond);
  if (!(slope * chord > 0)) return 0;
  if (chord * chord_beyond < 0 && std::abs(slope) > 3 * std::abs(chord)) return 3 * chord;
  return slope;
}

/// The weighted harmonic mean of the chords on both sides, 0 where they do not go the same way.
std::vector<double> monotone_slopes(std::span<const double> x, std::span<const double> y) {
  const std::size_t n = x.size();
  const auto h = [&](std::size_t i) { return x[i + 1] - x[i]; };
  const auto chord = [&](std::size_t i) { return (y[i + 1] - y[i]) / h(i); };
  if (n == 2) return {chord(0), chord(0)};
  std::vector<double> slopes(n, 0.0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double left = chord(i - 1), right = chord(i);
    if (!((left > 0 && right > 0) || (left < 0 && right < 0))) continue;
    const double of_left = 2 * h(i) + h(i - 1), of_right = h(i) + 2 * h(i - 1);
    slopes[i] = (of_left + of_right) / (of_left / left + of_right / right);
  }
  slopes[0] = end_slope(h(0), h(1), chord(0), chord(1));
  slopes[n - 1] = end_slope(h(n - 2), h(n - 3), chord(n - 2), chord(n - 3));
  return slopes;
}

std::vector<double> shape_of(std::span<const double> x, std::span<const double> y, Interpolation kind) {
  switch (kind) {
    case Interpolation::linear:
      return {};
    case Interpolation::monotone:
      return monotone_slopes(x, y);
    case Interpolation::spline:
      return curvatures(x, y);
  }
  return {};
}

}  // namespace

Interpolant::Interpolant(std::span<const double> x, std::span<const double> y, Interpolation kind)
    : kind_(kind), x_(x.begin(), x.end()), y_(y.begin(), y.end()), shape_(shape_of(x, y, kind)) {}

Interpolant::Cubic Interpolant::cubic(std::size_t i) const {
  const double h = x_[i + 1] - x_[i], chord = (y_[i + 1] - y_[i]) / h;
  if (kind_ == Interpolation::linear) return {chord, 0, 0};
  const double begin = shape_[i], end = shape_[i + 1];
  if (kind_ == Interpolation::spline) return {chord - h * (2 * begin + end) / 6, begin, (end - begin) / h};
  return {begin, 2 * (3 * chord - 2 * begin - end) / h, 6 * (begin + end - 2 * chord) / (h * h)};
}

Interpolant::Value Interpolant::value(std::size_t i, const Cubic& c, double d) const {
  return {y_[i] + d * (c.slope + d * (c.curvature / 2 + d * c.third / 6)),
          c.slope + d * (c.curvature + d * c.third / 2), c.curvature + d * c.third};
}

Interpolant::Value Interpolant::at(double x) const {
  const auto above = std::upper_bound(x_.begin() + 1, x_.end() - 1, x);
  const auto i = static_cast<std::size_t>(above - x_.begin()) - 1;
  return value(i, cubic(i), x - x_[i]);
}

Interpolant::Departure Interpolant::farthest_departure() const {
  Departure farthest;
  for (std::size_t i = 0; i + 1 < x_.size(); ++i) {
    const Cubic c = cubic(i);
    const auto [lower, upper] = std::minmax(y_[i], y_[i + 1]);
    // slope + curvature d + third d^2 / 2 = 0, without cancellation
    const double q =
        -(c.curvature + std::copysign(std::sqrt(c.curvature * c.curvature - 2 * c.third * c.slope), c.curvature));
    for (const double d : {q / c.third, 2 * c.slope / q}) {
      if (!(d > 0 && d < x_[i + 1] - x_[i])) continue;  // nor where there is no such place
      const double found = value(i, c, d).value, by = std::max(lower - found, found - upper);
      if (by > farthest.by) farthest = {x_[i] + d, found, lower, upper, by};
    }
  }
  return farthest;
}

}  // namespace assay
