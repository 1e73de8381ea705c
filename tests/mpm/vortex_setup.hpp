// SPDX-License-Identifier: BSD-3-Clause
// Setups of the particle method for tests: the paper's vortex on a coarse ring, and a plain block of particles.
#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "harness/motion/kinds/vortex.hpp"
#include "mpm/basis/basis.hpp"
#include "mpm/patch/methods.hpp"
#include "mpm/seeding/gauss_lattice.hpp"
#include "mpm/seeding/lattice.hpp"
#include "mpm/simulation.hpp"
#include "tests/harness/elastic_material.hpp"

namespace assay::mpm {

/// For the names of tests.
inline std::string way_name(const testing::TestParamInfo<Method>& info) {
  std::string name = name_of(info.param);
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
}
/// The methods that every change waits for, and the others: of lumped mass with the stress last, or of B-splines of
/// degree 2.
inline std::vector<Method> methods_that_are(bool usual) {
  std::vector<Method> methods;
  for (const Method& method : all_methods()) {
    const bool plain = method.is_lumped() && method.update == Update::usl;
    if ((plain || method.basis == Basis::bspline2) == usual) methods.push_back(method);
  }
  return methods;
}

inline void PrintTo(const Method& method, std::ostream* out) { *out << name_of(method); }

/// The free ring of the paper's vortex, 2x2 particles a cell, so many cells across; body force in closed form.
inline Setup<2> vortex_setup(int across, const Method& way = {}, std::array<int, 2> per_cell = {2, 2}) {
  Setup<2> setup;
  const Vortex motion;
  const double h = (motion.outer - motion.inner) / across;
  const std::array<double, 2> lower{-motion.outer, -motion.outer}, upper{motion.outer, motion.outer};
  setup.method = way;
  setup.grid = grid_around(lower, upper, h, 4);
  setup.seeds = cartesian_lattice(lower, upper, h, per_cell, [&](const auto& X) {
    return motion.moves({X[0], X[1], 0}) ? Fate::stepped : Fate::absent;
  });
  setup.density = 1000;
  setup.material = elastic_material();
  setup.motion = motion;
  setup.body_force = true;
  setup.exact = exact_polar(motion, setup.density,
                            std::make_shared<const Response>(*ClosedForm::of(setup.material, motion.baseline())));
  return setup;
}

/// The ring as part of a square whose faces are free, far from what moves.
inline Setup<2> free_square_setup(int across, const Method& way) {
  Setup<2> setup = vortex_setup(across, way);
  const std::array<double, 2> lower{-2, -2}, upper{2, 2};
  setup.grid = grid_around(lower, upper, setup.grid.spacing, 4);
  setup.seeds = cartesian_lattice(lower, upper, setup.grid.spacing, {2, 2}, [](const auto&) { return Fate::stepped; });
  return setup;
}

/// The same ring, clipped from the lattice or cut into sectors, with the averaged body force.
inline Setup<2> averaged_setup(int across, bool polar, const Method& way = {}) {
  Setup<2> setup = vortex_setup(across, way);
  const auto& motion = *setup.motion->as<Vortex>();
  const Annulus ring{motion.inner, motion.outer};
  setup.seeds =
      polar ? polar_lattice(ring, setup.grid.spacing, {2, 2}) : clipped_lattice(ring, setup.grid.spacing, {2, 2});
  setup.evaluation = Evaluation::domain_average;
  return setup;
}

/// The square around the ring with free faces, its particles at the cells' Gauss points or moved at random.
inline Setup<2> square_setup(int across, bool gauss, const Method& way = {}) {
  Setup<2> setup = vortex_setup(across, way);
  const std::array<double, 2> lower{-1.5, -1.5}, upper{1.5, 1.5};
  const double h = setup.grid.spacing;
  const auto always = [](const auto&) { return Fate::stepped; };
  setup.grid = grid_around(lower, upper, h, 4);
  setup.seeds =
      gauss ? gauss_lattice(lower, upper, h, {2, 2}, always) : cartesian_lattice(lower, upper, h, {2, 2}, always);
  if (!gauss) disturb(setup.seeds, 0.25, 1);
  return setup;
}

/// A block of 2^Dim cells with 2^Dim particles each, at rest, in a grid with 9 empty cells on each side of it.
template <int Dim>
Setup<Dim> block_setup(const Method& way) {
  Setup<Dim> setup;
  setup.method = way;
  setup.grid.spacing = 0.1;
  setup.grid.first.fill(-10);
  setup.grid.count.fill(21);
  setup.seeds.half_size.fill(0.025);
  const int along = 4;
  int count = 1;
  for (int d = 0; d < Dim; ++d) count *= along;
  for (int p = 0; p < count; ++p) {
    for (int d = 0, rest = p; d < Dim; ++d, rest /= along) {
      setup.seeds.X[static_cast<std::size_t>(d)].push_back(-0.075 + 0.05 * (rest % along));
    }
  }
  setup.density = 1000;
  setup.material = elastic_material();
  return setup;
}

/// Momentum of the particles [N s].
template <int Dim>
Vec<Dim> momentum(const State<Dim>& s) {
  Vec<Dim> sum{};
  for (int d = 0; d < Dim; ++d) {
    for (std::size_t p = 0; p < s.particles; ++p) {
      sum[static_cast<std::size_t>(d)] += s.column(Column::mass)[p] * s.column(Column::velocity, d)[p];
    }
  }
  return sum;
}

/// Sum of m |v| [N s].
template <int Dim>
double momentum_scale(const State<Dim>& s) {
  double sum = 0;
  for (std::size_t p = 0; p < s.particles; ++p) {
    double square = 0;
    for (int d = 0; d < Dim; ++d) square += std::pow(s.column(Column::velocity, d)[p], 2);
    sum += s.column(Column::mass)[p] * std::sqrt(square);
  }
  return sum;
}

/// [J]
template <int Dim>
double kinetic_energy(const State<Dim>& s) {
  double sum = 0;
  for (int d = 0; d < Dim; ++d) {
    for (std::size_t p = 0; p < s.particles; ++p) {
      sum += 0.5 * s.column(Column::mass)[p] * std::pow(s.column(Column::velocity, d)[p], 2);
    }
  }
  return sum;
}

/// About E_z [N m s].
inline double angular_momentum(const State<2>& s) {
  double sum = 0;
  for (std::size_t p = 0; p < s.particles; ++p) {
    sum += s.column(Column::mass)[p] * (s.column(Column::position, 0)[p] * s.column(Column::velocity, 1)[p] -
                                        s.column(Column::position, 1)[p] * s.column(Column::velocity, 0)[p]);
  }
  return sum;
}

/// Root mean square of |x - x_exact| over the particles, which all move [m].
inline double displacement_error(const State<2>& s, double t) {
  double sum = 0;
  for (std::size_t p = 0; p < s.particles; ++p) {
    const Vector3 X(s.column(Column::reference_position, 0)[p], s.column(Column::reference_position, 1)[p], 0);
    const Vector3 x(s.column(Column::position, 0)[p], s.column(Column::position, 1)[p], 0);
    sum += (x - (*s.setup.motion)->at(X, t).x).squaredNorm();
  }
  return std::sqrt(sum / static_cast<double>(s.particles));
}

}  // namespace assay::mpm
