// SPDX-License-Identifier: BSD-3-Clause
// A free elastic body that flies: nothing but rounding may happen to it.
#include <algorithm>
#include <cmath>

#include "mpm/patch/patch.hpp"

namespace assay::mpm {

namespace {

constexpr double translation_threshold = 1e-12;                       ///< rounding: at most 6e-14 is found
constexpr Vec<2> velocity{1.4142135623730951, -0.57735026918962573};  ///< sqrt 2, -1/sqrt 3 [m/s]
constexpr double cells_crossed = 3.7;

struct Flight {
  double velocity = 0, deformation = 0, momentum = 0;  ///< over |v|; of F; over the momentum
  double place = 0;                                    ///< of particles and corners, over h
  std::optional<Finding> finding;
  int steps = 0;
};

/// Of a body that has flown straight for t.
double misplacement(const State<2>& s, double t) {
  const Vec<2>& half = s.setup.seeds.half_size;
  double largest = 0;
  for (std::size_t p = 0; p < s.particles; ++p) {
    for (std::size_t d = 0; d < 2; ++d) {
      const double x = s.column(Column::reference_position, static_cast<int>(d))[p] + velocity[d] * t;
      largest = std::max(largest, std::abs(s.column(Column::position, static_cast<int>(d))[p] - x));
      for (std::size_t c = 0; s.has(Column::corners) && c < 4; ++c) {
        const double corner = s.column(Column::corners, static_cast<int>(2 * c + d))[p];
        largest = std::max(largest, std::abs(corner - x - ((c >> d & 1) ? half[d] : -half[d])));
      }
    }
  }
  return largest / s.setup.grid.spacing;
}

Flight fly(const Method& method, const Bench& bench, int across) {
  const Setup<2> setup = patch_setup(method, bench, across);
  Simulation<2> simulation(setup, bench.passes(setup));
  State<2>& s = simulation.state();
  for (std::size_t p = 0; p < s.particles; ++p) {
    for (int d = 0; d < 2; ++d) s.column(Column::velocity, d)[p] = velocity[static_cast<std::size_t>(d)];
  }
  const Momentum before = momentum_of(s);
  const double speed = std::hypot(velocity[0], velocity[1]), dt = time_step(bench, across, speed);
  Flight flight;
  flight.steps = static_cast<int>(std::ceil(cells_crossed * setup.grid.spacing / (velocity[0] * dt)));
  for (int k = 0; k < flight.steps; ++k) {
    flight.finding = simulation.step(k * dt, dt);
    if (flight.finding) return flight;
  }
  for (std::size_t p = 0; p < s.particles; ++p) {
    for (int d = 0; d < 2; ++d) {
      const double v = s.column(Column::velocity, d)[p];
      flight.velocity = std::max(flight.velocity, std::abs(v - velocity[static_cast<std::size_t>(d)]) / speed);
    }
    for (int c = 0; c < 4; ++c) {
      const double exact = c % 3 == 0 ? 1 : 0;
      flight.deformation = std::max(flight.deformation, std::abs(s.column(Column::deformation_gradient, c)[p] - exact));
    }
  }
  flight.place = misplacement(s, flight.steps * dt);
  const Momentum after = momentum_of(s);
  for (std::size_t d = 0; d < 2; ++d) {
    flight.momentum = std::max(flight.momentum, std::abs(after.linear[d] - before.linear[d]) / before.scale);
  }
  return flight;
}

}  // namespace

std::vector<check::TestResult> translation(const Method& method, const Bench& bench) {
  const Flight flight = fly(method, bench, bench.quick ? 8 : 32);
  Figure figure{std::max({flight.velocity, flight.deformation, flight.momentum, flight.place}), {}, {}};
  if (flight.finding) {
    figure = {INFINITY, {}, "ends before its time: " + flight.finding->reason};
  } else {
    figure.sentence = "through " + digits(cells_crossed) + " cells in " + std::to_string(flight.steps) +
                      " steps: velocity off by " + digits(flight.velocity) + ", F by " + digits(flight.deformation) +
                      ", momentum by " + digits(flight.momentum) + ", places by " + digits(flight.place) + " h";
  }
  return {judged(method, "translation", figure, translation_threshold, "uniform motion disturbed")};
}

}  // namespace assay::mpm
