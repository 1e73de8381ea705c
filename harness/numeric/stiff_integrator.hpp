// SPDX-License-Identifier: BSD-3-Clause
// Boost.Odeint's Rosenbrock method behind plain types. This file and its source also compile as C++17: the uBLAS of
// Boost 1.74, which the method needs, does not as C++20.
#pragma once

#include <functional>
#include <vector>

namespace assay {

/// Rate of x at (x, t).
using RateFunction = std::function<void(const std::vector<double>& x, double t, std::vector<double>& x_rate)>;

struct StiffOptions {
  double tolerance = 1e-10;                 ///< absolute, of a step
  double shortest = 0;                      ///< a step that would have to be shorter has failed
  double window_begin = 0, window_end = 1;  ///< the rate may jump at both: differences in t stay inside
};

/// x from t to `to` by Rosenbrock's method of order 4 with error control, the Jacobian by differences (an error there
/// costs steps, not accuracy). x is scaled: all components of order 1. `step`: in/out, to try next. Returns the
/// accepted steps; -1 where the step became too short, with x and t of the last accepted one.
int integrate_stiff(const RateFunction& rate, std::vector<double>& x, double& t, double to, double& step,
                    const StiffOptions& options);

}  // namespace assay
