// SPDX-License-Identifier: BSD-3-Clause
// One step without body force, particles of unequal mass, speed, F and stress on an irregular set.
#include <cmath>

#include "harness/numeric/norms.hpp"
#include "mpm/patch/patch.hpp"

namespace assay::mpm {

namespace {

constexpr double momentum_threshold = 1e-13;  ///< rounding: at most 4e-15 is found

/// v = v_0 + A X, before each particle's own part of it.
template <int Dim>
Mat<Dim> swirl() {
  if constexpr (Dim == 2) return {0, -1, 1, 0.5};
  if constexpr (Dim == 3) return {0, -1, 0.4, 1, 0.5, -0.7, -0.6, 0.9, -0.3};
}

/// Every particle its own mass, velocity, F and stress.
template <int Dim>
void disturb_all(State<Dim>& s) {
  Noise noise;
  for (std::size_t p = 0; p < s.particles; ++p) {
    Vec<Dim> v = image_of<Dim>(swirl<Dim>(), s.template at<Dim>(Column::position, p));
    v[0] = 0.3 + v[0];
    s.column(Column::mass)[p] *= 1 + 0.5 * noise();
    for (std::size_t d = 0; d < Dim; ++d) s.column(Column::velocity, d)[p] = v[d] + 0.2 * noise();
    Mat<Dim> F;
    for (std::size_t c = 0; c < F.size(); ++c) F[c] = s.column(Column::deformation_gradient, c)[p] += 0.1 * noise();
    const auto sigma = stress_at<Dim>(*s.setup.material, F);
    for (std::size_t c = 0; c < sigma.size(); ++c) s.column(Column::stress, c)[p] = sigma[c];
  }
}

/// Relative changes over one step.
struct Change {
  double grid = 0;       ///< of mass and momentum on the grid against those of the particles
  double particles = 0;  ///< of the particles' momentum
  double angular = 0;    ///< of their angular momentum
};

template <int Dim>
Change change_of(const State<Dim>& s, const Momentum<Dim>& before) {
  const Momentum<Dim> after = momentum_of(s);
  std::array<double, Dim + 1> grid{};
  double mass = 0;
  for (std::size_t i = 0; i < s.inertia.nodes(); ++i) {
    for (std::size_t c = 0; c < grid.size(); ++c) grid[c] += s.inertia.node(i)[c];
  }
  for (std::size_t p = 0; p < s.particles; ++p) mass += s.column(Column::mass)[p];
  Change change{std::abs(grid[0] / mass - 1), 0, 0};
  for (std::size_t d = 0; d < Dim; ++d) {
    change.grid = larger(change.grid, std::abs(grid[1 + d] - before.linear[d]) / before.scale);
    change.particles = larger(change.particles, std::abs(after.linear[d] - before.linear[d]) / before.scale);
  }
  for (std::size_t d = 0; d < 3; ++d)
    change.angular = larger(change.angular, std::abs(after.angular[d] - before.angular[d]) / before.angular_scale);
  return change;
}

template <int Dim>
Change step_once(const Method& method, const Bench<Dim>& bench, int across, double share) {
  const Setup<Dim> setup = patch_setup(method, bench, across);
  Simulation<Dim> simulation(setup, bench.passes(setup));
  State<Dim>& s = simulation.state();
  arrange(s, Arrangement::jittered);
  disturb_all(s);
  const double dt = share * time_step(bench, across, 1);
  if (method.is_affine() && simulation.step(0, dt)) return {INFINITY, INFINITY, INFINITY};  // what affine carries
  const Momentum<Dim> before = momentum_of(s);
  if (simulation.step(0, dt)) return {INFINITY, INFINITY, INFINITY};
  return change_of(s, before);
}

}  // namespace

template <int Dim>
std::vector<check::TestResult> momentum(const Method& method, const Bench<Dim>& bench) {
  const int across = cells_across(bench);
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

template std::vector<check::TestResult> momentum(const Method&, const Bench<ASSAY_DIMENSION>&);

}  // namespace assay::mpm
