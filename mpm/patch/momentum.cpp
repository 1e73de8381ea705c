// SPDX-License-Identifier: BSD-3-Clause
// One step without body force, particles of unequal mass, speed, F and stress on an irregular set.
#include <cmath>

#include "harness/numeric/norms.hpp"
#include "mpm/patch/patch.hpp"

namespace assay::mpm {

namespace {

constexpr double momentum_threshold = 1e-13;  ///< rounding: at most 4e-15 is found

/// Every particle its own mass, velocity, F and stress.
void disturb(State<2>& s) {
  Noise noise;
  for (std::size_t p = 0; p < s.particles; ++p) {
    const double x = s.column(Column::position, 0)[p], y = s.column(Column::position, 1)[p];
    s.column(Column::mass)[p] *= 1 + 0.5 * noise();
    s.column(Column::velocity, 0)[p] = 0.3 - y + 0.2 * noise();
    s.column(Column::velocity, 1)[p] = x + 0.5 * y + 0.2 * noise();
    Mat<2> F;
    for (std::size_t c = 0; c < 4; ++c) F[c] = s.column(Column::deformation_gradient, c)[p] += 0.1 * noise();
    const auto sigma = stress_at(*s.setup.material, F);
    for (std::size_t c = 0; c < sigma.size(); ++c) s.column(Column::stress, c)[p] = sigma[c];
  }
}

/// Relative changes over one step.
struct Change {
  double grid = 0;       ///< of mass and momentum on the grid against those of the particles
  double particles = 0;  ///< of the particles' momentum
  double angular = 0;    ///< of their angular momentum
};

Change change_of(const State<2>& s, const Momentum& before) {
  const Momentum after = momentum_of(s);
  std::array<double, 3> grid{};
  double mass = 0;
  for (std::size_t i = 0; i < s.inertia.nodes(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) grid[c] += s.inertia.node(i)[c];
  }
  for (std::size_t p = 0; p < s.particles; ++p) mass += s.column(Column::mass)[p];
  Change change{std::abs(grid[0] / mass - 1), 0, std::abs(after.angular - before.angular) / before.angular_scale};
  for (std::size_t d = 0; d < 2; ++d) {
    change.grid = larger(change.grid, std::abs(grid[1 + d] - before.linear[d]) / before.scale);
    change.particles = larger(change.particles, std::abs(after.linear[d] - before.linear[d]) / before.scale);
  }
  return change;
}

Change step_once(const Method& method, const Bench& bench, int across, double share) {
  const Setup<2> setup = patch_setup(method, bench, across);
  Simulation<2> simulation(setup, bench.passes(setup));
  State<2>& s = simulation.state();
  arrange(s, Arrangement::jittered);
  disturb(s);
  const double dt = share * time_step(bench, across, 1);
  if (method.is_affine() && simulation.step(0, dt)) return {INFINITY, INFINITY, INFINITY};  // what affine carries
  const Momentum before = momentum_of(s);
  if (simulation.step(0, dt)) return {INFINITY, INFINITY, INFINITY};
  return change_of(s, before);
}

}  // namespace

std::vector<check::TestResult> momentum(const Method& method, const Bench& bench) {
  const int across = bench.quick ? 8 : 32;
  const Change whole = step_once(method, bench, across, 1), half = step_once(method, bench, across, 0.5);
  Figure angular{whole.angular, "the angular momentum changes by " + digits(whole.angular) +
                                    " of its scale in a step, by " + digits(half.angular) + " in half a step"};
  if (whole.angular > momentum_threshold) angular.order = observed_order(2, whole.angular, 1, half.angular);
  return {judged(method, "momentum.linear",
                 {larger(whole.grid, whole.particles),
                  "mass and momentum on the grid are off by " + digits(whole.grid) +
                      ", the particles' momentum after a step by " + digits(whole.particles)},
                 momentum_threshold, "momentum not conserved"),
          judged(method, "momentum.angular", angular, momentum_threshold, "angular momentum not conserved")};
}

}  // namespace assay::mpm
