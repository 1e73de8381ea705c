// SPDX-License-Identifier: BSD-3-Clause
// The same stress everywhere: f_i = -sum V sigma grad phi_ip must vanish at nodes that see nothing but the inside.
#include <algorithm>
#include <cmath>
#include <tuple>

#include "mpm/patch/patch.hpp"

namespace assay::mpm {

namespace {

constexpr double threshold = 1e-12;  ///< rounding: at most 2e-14 is found
constexpr double reach = 2;          ///< of a node, in h: more than the support of any basis here, domains included

/// Whether a square of `reach` around the node lies inside the body, which is F times the unit square, shifted by less
/// than one h.
bool is_inner(const Vec<2>& node, const Mat<2>& F, double h) {
  const Mat<2> inverse = inverse_transpose<2>(F, determinant<2>(F));  // its transpose is F^-1
  for (const int i : {-1, 1}) {
    for (const int j : {-1, 1}) {
      const double x = node[0] + i * (reach + 1) * h, y = node[1] + j * (reach + 1) * h;
      if (std::abs(inverse[0] * x + inverse[2] * y) > 0.5) return false;
      if (std::abs(inverse[1] * x + inverse[3] * y) > 0.5) return false;
    }
  }
  return true;
}

/// The same stress at every particle, whatever its F: a body may be prestressed [Pa].
using Stress = std::array<double, stress_components<2>>;

void fill(State<2>& s, const Stress& sigma) {
  for (std::size_t c = 0; c < sigma.size(); ++c) {
    std::fill_n(s.column(Column::stress, static_cast<int>(c)), s.particles, sigma[c]);
  }
}

Pass<2> prescribed_stress(const Stress& sigma) {
  Pass<2> pass;
  pass.name = "prescribed_stress";
  pass.bind = [sigma](State<2>& s) -> Kernel { return [&s, sigma](const Instant&) { fill(s, sigma); }; };
  return pass;
}

/// Largest inner force over the largest stress times h.
double inner_force(const Method& method, const Bench& bench, Arrangement arrangement, int across) {
  Setup<2> setup = patch_setup(method, bench, across);
  if (arrangement == Arrangement::graded) setup.seeds = graded_seeds(across);
  const double h = setup.grid.spacing;
  Stress sigma = stress_at(*bench.material, homogeneous_deformation());
  auto passes = bench.passes(setup);
  insert_after(passes, "stress", prescribed_stress(sigma));
  Simulation<2> simulation(setup, passes);
  State<2>& s = simulation.state();
  arrange(s, arrangement);
  fill(s, sigma);
  const Mat<2> F{s.column(Column::deformation_gradient, 0)[0], s.column(Column::deformation_gradient, 1)[0],
                 s.column(Column::deformation_gradient, 2)[0], s.column(Column::deformation_gradient, 3)[0]};
  if (simulation.step(0, 1e-6)) return INFINITY;
  double largest = 0;
  for (std::int32_t j = 0; j < setup.grid.count[1]; ++j) {
    for (std::int32_t i = 0; i < setup.grid.count[0]; ++i) {
      if (!is_inner({setup.grid.coordinate(0, i), setup.grid.coordinate(1, j)}, F, h)) continue;
      const double* f = s.force.node(static_cast<std::size_t>(j * setup.grid.count[0] + i));
      largest = std::max({largest, std::abs(f[0]), std::abs(f[1])});
    }
  }
  double scale = 0;
  for (const double component : sigma) scale = std::max(scale, std::abs(component));
  return largest / (scale * h);
}

}  // namespace

std::vector<check::TestResult> constant_stress(const Method& method, const Bench& bench) {
  const std::vector<std::tuple<Arrangement, const char*, const char*>> cases{
      {Arrangement::seeded, "stress.seeded", "particles as seeded"},
      {Arrangement::shifted, "stress.shifted", "the lattice moved by a part of a cell"},
      {Arrangement::deformed, "stress.deformed", "stretched and sheared, domains still without gaps"},
      {Arrangement::graded, "stress.graded", "the same, rows and columns of unequal width"},
      {Arrangement::jittered, "stress.jittered", "particles moved by up to 0.3 of their distance"}};
  std::vector<check::TestResult> results;
  for (const auto& [arrangement, id, what] : cases) {
    const double force = inner_force(method, bench, arrangement, bench.quick ? 16 : 32);
    const Figure figure{force, {}, std::string(what) + ": largest inner force " + digits(force) + " of stress times h"};
    results.push_back(judged(method, id, figure, threshold, "force in a body under constant stress"));
  }
  return results;
}

}  // namespace assay::mpm
