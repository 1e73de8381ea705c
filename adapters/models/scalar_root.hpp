// SPDX-License-Identifier: BSD-3-Clause
// Roots of one equation in one unknown, and their derivatives.
#pragma once

#include <cmath>
#include <limits>
#include <type_traits>

#include "adapters/models/tensor_functions.hpp"

namespace assay::models {

/// Where f falls or rises through 0 between low, f_low = f(low), and high (may be infinite), to |f| <= tolerance:
/// secant steps from low and `guess`, bisection (doubling) where they leave the bracket. NaN where that does not
/// settle.
template <class Function>
double root_between(const Function& f, double low, double f_low, double high, double guess, double tolerance) {
  constexpr int most = 200;
  double before = low, f_before = f_low, x = guess;
  const bool rises = f_before < 0;
  for (int i = 0; i < most; ++i) {
    const double f_x = f(x);
    if (std::abs(f_x) <= tolerance) return x;
    ((f_x < 0) == rises ? low : high) = x;
    double next = x - f_x * (x - before) / (f_x - f_before);
    if (!(next > low && next < high)) next = std::isinf(high) ? 2 * x : 0.5 * (low + high);
    before = x, f_before = f_x;
    if (std::abs(next - x) <= 4e-16 * std::abs(x) && std::abs(f_x) <= 1e3 * tolerance) return x;
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
