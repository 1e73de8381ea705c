// SPDX-License-Identifier: BSD-3-Clause
// After which steps of a run something is due.
#include <algorithm>
#include <cmath>

#include "drivers/simulation/simulate.hpp"

namespace assay::drivers {

namespace {

/// Steps after which something is due `count` times over the run.
std::set<std::int64_t> schedule(const PosedScene& problem, int count) {
  std::set<std::int64_t> due;
  if (count <= 0) return due;
  for (int k = 0; k <= count; ++k) {
    due.insert(static_cast<std::int64_t>(std::llround(static_cast<double>(problem.steps) * k / count)));
  }
  const double half = 0.5 * problem.period();
  if (half <= problem.scene.time.end) due.insert(std::llround(half / problem.dt));
  return due;
}

}  // namespace

Observations observations_of(const PosedScene& problem) {
  const OutputChoice& output = problem.scene.output;
  const bool compared = problem.compared;
  Observations due{schedule(problem, compared ? std::max(output.errors, 1) : 0),
                   schedule(problem, output.particles > 0          ? output.particles
                                     : output.pictures && compared ? 2
                                                                   : 0),
                   schedule(problem, output.accounts ? std::max(output.errors, 1) : 0)};
  const double from = output.each_step_from.value_or(problem.scene.time.end);
  for (std::int64_t k = problem.steps; output.each_step_from && k >= 0 && problem.time_of_step(k) >= from; --k) {
    due.shots.insert(k);
  }
  return due;
}

}  // namespace assay::drivers
