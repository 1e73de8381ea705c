// SPDX-License-Identifier: BSD-3-Clause
// Setups of the particle method in space for tests: a vortex in a ball, and a box.
#pragma once

#include "harness/motion/kinds/vortex3d.hpp"
#include "mpm/patch/methods.hpp"
#include "mpm/seeding/lattice.hpp"
#include "mpm/simulation.hpp"
#include "tests/harness/elastic_material.hpp"

namespace assay::mpm {

/// The free ball of radius 1 m about (1, 2, 3), so many cells across its radius, 2x2x2 particles a cell; b in closed
/// form.
inline Setup<3> ball_setup(int across, const Method& way, double peak = 1) {
  Setup<3> setup;
  Vortex3d motion;
  motion.one.axis = {1, 2, 3};
  motion.amplitude.peak = peak;
  const double h = motion.one.radius / across;
  const std::array<double, 3> lower{-1, -1, -1}, upper{1, 1, 1};
  setup.method = way;
  setup.grid = grid_around(lower, upper, h, 4);
  setup.seeds = cartesian_lattice(lower, upper, h, {2, 2, 2}, [&](const auto& X) {
    return motion.place({X[0], X[1], X[2]}) ? Fate::stepped : Fate::absent;
  });
  setup.density = 1000;
  setup.material = elastic_material();
  setup.motion = motion;
  setup.body_force = true;
  setup.exact = exact_meridian(motion, setup.density,
                               std::make_shared<const Response>(*ClosedForm::of(setup.material, motion.baseline())));
  return setup;
}

inline Vector3 at_particle(const State<3>& s, Column column, std::size_t p) {
  return {s.column(column, 0)[p], s.column(column, 1)[p], s.column(column, 2)[p]};
}

/// Root mean square of |x - x_exact| over the particles [m].
inline double displacement_error(const State<3>& s, double t) {
  double sum = 0;
  for (std::size_t p = 0; p < s.particles; ++p) {
    const Vector3 X = at_particle(s, Column::reference_position, p);
    sum += (at_particle(s, Column::position, p) - (*s.setup.motion)->at(X, t).x).squaredNorm();
  }
  return std::sqrt(sum / static_cast<double>(s.particles));
}

}  // namespace assay::mpm
