// SPDX-License-Identifier: BSD-3-Clause
#include "harness/cubic_spline.hpp"

#include <algorithm>

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

}  // namespace

CubicSpline::CubicSpline(std::span<const double> x, std::span<const double> y)
    : x_(x.begin(), x.end()), y_(y.begin(), y.end()) {
  if (x.size() >= 4)
    curvature_ = not_a_knot(x, y);
  else
    curvature_.assign(x.size(), x.size() == 3 ? parabola_curvature(x, y) : 0.0);
}

CubicSpline::Value CubicSpline::at(double x) const {
  const auto above = std::upper_bound(x_.begin() + 1, x_.end() - 1, x);
  const auto i = static_cast<std::size_t>(above - x_.begin()) - 1;
  const double h = x_[i + 1] - x_[i], d = x - x_[i], M0 = curvature_[i], M1 = curvature_[i + 1];
  const double start = (y_[i + 1] - y_[i]) / h - h * (2 * M0 + M1) / 6, third = (M1 - M0) / h;
  return {y_[i] + d * (start + d * (M0 / 2 + d * third / 6)), start + d * (M0 + d * third / 2), M0 + d * third};
}

}  // namespace assay
