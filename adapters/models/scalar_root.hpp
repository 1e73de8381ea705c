// SPDX-License-Identifier: BSD-3-Clause
// Roots of one equation in one unknown, and their derivatives.
#pragma once

#include <cmath>
#include <limits>
#include <type_traits>

#include "adapters/models/tensor_functions.hpp"

namespace assay::models {

/// Where f goes through 0 in the sense of `slope` between low and high (may be infinite), to |f| <= tolerance, x being
/// the last argument that f was given: from `guess` with that slope, then secant steps; bisection (doubling) where they
/// leave the bracket. NaN where that does not settle.
double root_between(const auto& f, double low, double high, double guess, double slope, double tolerance) {
  constexpr int most = 200;
  const bool rises = slope > 0;
  double x = guess, before = guess, f_before = 0;
  for (int i = 0; i < most; ++i) {
    const double f_x = f(x);
    if (std::abs(f_x) <= tolerance) return x;
    ((f_x < 0) == rises ? low : high) = x;
    if (i > 0) slope = (f_x - f_before) / (x - before);
    double next = x - f_x / slope;
    if (!(next > low && next < high)) next = std::isinf(high) ? 2 * x : 0.5 * (low + high);
    if (std::abs(next - x) <= 4e-16 * std::abs(x) && std::abs(f_x) <= 1e3 * tolerance) return x;
    before = x, f_before = f_x;
    x = next;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

/// The root x of f, of which `value` is the value, with the derivatives that f's other arguments give it: Newton steps
/// with a difference quotient over `scale`.
template <class S, class Function>
S root_with_derivatives(double value, double scale, const Function& f) {
  if constexpr (std::is_same_v<S, double>) {
    return value;
  } else {
    constexpr int steps = 3;
    const double h = 1e-4 * scale, slope = (value_of(f(S(value + h))) - value_of(f(S(value - h)))) / (2 * h);
    S x(value);
    for (int i = 0; i < steps; ++i) x = x - f(x) / S(slope);
    return x;
  }
}

}  // namespace assay::models
