// SPDX-License-Identifier: BSD-3-Clause
// The same stress everywhere: f_i = -sum V sigma grad phi_ip must vanish at nodes that see nothing but the inside, and
// sum f_i (x) x_i = -V sigma whatever the particles' places, so that there are forces at all.
#include <algorithm>
#include <cmath>
#include <tuple>

#include "harness/numeric/norms.hpp"
#include "mpm/kernels/affine.hpp"
#include "mpm/patch/patch.hpp"

namespace assay::mpm {

namespace {

constexpr double stress_threshold = 1e-12;  ///< rounding: at most 2e-14 is found, 9e-14 of the sums

/// Whether a square of `reach` [h] around the node lies inside the body, which is F times the unit square, shifted by
/// less than one h.
bool is_inner(const Vec<2>& node, int reach, const Mat<2>& F, double h) {
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
  for (std::size_t c = 0; c < sigma.size(); ++c) std::fill_n(s.column(Column::stress, c), s.particles, sigma[c]);
}

Pass<2> prescribed_stress(const Stress& sigma) {
  Pass<2> pass;
  pass.name = "prescribed_stress";
  pass.bind = [sigma](State<2>& s) -> Kernel { return [&s, sigma](const Instant&) { fill(s, sigma); }; };
  return pass;
}

/// Of the nodal forces: the largest inner one over sigma h, and how far sum f_i (x) x_i is from - V sigma, over V
/// sigma.
struct Forces {
  double inner = INFINITY, total = INFINITY;
};

Forces summed(const State<2>& s, const Mat<2>& F, const Stress& sigma, double volume) {
  const GridGeometry<2>& grid = s.setup.grid;
  const int reach = std::max(2, traits_of<2>(s.method.basis).nodes_across / 2);  // no basis supports more, with domains
  Mat<2> moment{};
  double largest = 0, scale = 0, total = 0;
  for (std::int32_t j = 0; j < grid.count[1]; ++j) {
    for (std::int32_t i = 0; i < grid.count[0]; ++i) {
      const Vec<2> x{grid.coordinate(0, i), grid.coordinate(1, j)};
      const double* f = s.force.node(static_cast<std::size_t>(j * grid.count[0] + i));
      for (std::size_t c = 0; c < 4; ++c) moment[c] += f[c / 2] * x[c % 2];
      if (is_inner(x, reach, F, grid.spacing)) largest = larger(largest, larger(std::abs(f[0]), std::abs(f[1])));
    }
  }
  for (const double component : sigma) scale = larger(scale, std::abs(component));
  for (std::size_t c = 0; c < 4; ++c) total = larger(total, std::abs(moment[c] / volume + sigma[c]));
  return {largest / (scale * grid.spacing), total / scale};
}

Forces forces(const Method& method, const Bench& bench, Arrangement arrangement) {
  const int across = bench.quick ? 16 : 32;
  Setup<2> setup = patch_setup(method, bench, across);
  if (arrangement == Arrangement::graded) setup.seeds = graded_seeds(across);
  const Stress sigma = stress_at(*bench.material, homogeneous_deformation());
  auto passes = bench.passes(setup);
  insert_after(passes, {Phase::early_stress, Phase::stress}, prescribed_stress(sigma));
  Simulation<2> simulation(setup, passes);
  State<2>& s = simulation.state();
  arrange(s, arrangement);
  fill(s, sigma);
  const Mat<2> F = s.at<4>(Column::deformation_gradient, 0);  // of all particles, at the beginning of the step
  double reference_volume = 0;                                // before the step, which may be the one that is wrong
  for (std::size_t p = 0; p < s.particles; ++p) reference_volume += s.column(Column::volume)[p];
  constexpr double no_time = 1e-9;  // in which the body does not move, and a last stage finds it as it was
  if (simulation.step(0, no_time)) return {};
  if (!method.is_total()) return summed(s, F, sigma, determinant<2>(F) * reference_volume);
  const double J = determinant<2>(F);
  const Mat<2> P = product<2>({J * sigma[0], J * sigma[1], J * sigma[2], J * sigma[3]}, inverse_transpose<2>(F, J));
  return summed(s, {1, 0, 0, 1}, {P[0], P[1], P[2], P[3], 0}, reference_volume);
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
  double total = 0;
  for (const auto& [arrangement, id, what] : cases) {
    const Forces found = forces(method, bench, arrangement);
    total = larger(total, found.total);
    const Figure figure{found.inner,
                        std::string(what) + ": largest inner force " + digits(found.inner) + " of stress times h"};
    results.push_back(judged(method, id, figure, stress_threshold, "force in a body under constant stress"));
  }
  const Figure figure{total, "sum f x is off by at most " + digits(total) + " of the volume times the stress"};
  results.push_back(judged(method, "stress.total", figure, stress_threshold, "forces do not add up to the stress"));
  return results;
}

}  // namespace assay::mpm
