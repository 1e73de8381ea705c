// SPDX-License-Identifier: BSD-3-Clause
// The same stress everywhere: f_i = -sum V sigma grad phi_ip must vanish at nodes that see nothing but the inside, and
// sum f_i (x) x_i = -V sigma whatever the particles' places, so that there are forces at all.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>

#include "harness/numeric/norms.hpp"
#include "mpm/kernels/affine.hpp"
#include "mpm/kernels/kernel_state.hpp"
#include "mpm/patch/patch.hpp"

namespace assay::mpm {

namespace {

constexpr double stress_threshold = 1e-12;  ///< rounding: at most 2e-14 is found, 9e-14 of the sums

/// Whether a square or cube of `reach` [h] around the node lies inside the body, which is F times the unit one.
template <int Dim>
bool is_inner(const Vec<Dim>& node, double reach, const Mat<Dim>& F, double h) {
  const Mat<Dim> back = inverse<Dim>(F);
  for (unsigned corner = 0; corner < 1u << Dim; ++corner) {
    Vec<Dim> x;
    for (std::size_t d = 0; d < Dim; ++d) x[d] = node[d] + ((corner >> d & 1) ? reach : -reach) * h;
    for (const double X : image_of<Dim>(back, x)) {
      if (std::abs(X) > 0.5) return false;
    }
  }
  return true;
}

/// The same stress at every particle, whatever its F: a body may be prestressed [Pa].
template <int Dim>
using Stress = std::array<double, stress_components<Dim>>;

template <int Dim>
void fill_stress(State<Dim>& s, const Stress<Dim>& sigma) {
  for (std::size_t c = 0; c < sigma.size(); ++c) std::fill_n(s.column(Column::stress, c), s.particles, sigma[c]);
}

template <int Dim>
Pass<Dim> prescribed_stress(const Stress<Dim>& sigma) {
  Pass<Dim> pass;
  pass.name = "prescribed_stress";
  pass.bind = [sigma](State<Dim>& s) -> Kernel { return [&s, sigma](const Instant&) { fill_stress<Dim>(s, sigma); }; };
  return pass;
}

/// Of the nodal forces: the largest inner one over sigma h, in space sigma h^2, and how far sum f_i (x) x_i is from - V
/// sigma, over V sigma.
struct Forces {
  double inner = INFINITY, total = INFINITY;
};

/// Of a body that is F times the unit one, moved by less than `margin` [h]; scale: the largest stress.
template <int Dim>
Forces summed(const State<Dim>& s, const Mat<Dim>& F, double margin, const Mat<Dim>& sigma, double scale,
              double volume) {
  const GridGeometry<Dim>& grid = s.setup.grid;
  // no basis but B-splines supports more than 2, with domains
  const int support = std::max(2, traits_of<Dim>(s.method.basis).nodes_across / 2);
  Mat<Dim> moment{};
  double largest = -1, total = 0;
  for_every_node(grid, [&](std::size_t i, const Vec<Dim>& x) {
    const double* f = s.force.node(i);
    for (std::size_t c = 0; c < moment.size(); ++c) moment[c] += f[c / Dim] * x[c % Dim];
    if (!is_inner<Dim>(x, support + margin, F, grid.spacing)) return;
    for (std::size_t d = 0; d < Dim; ++d) largest = larger(largest, std::abs(f[d]));
  });
  if (largest == -1) throw std::logic_error("no node sees nothing but the inside");
  for (std::size_t c = 0; c < moment.size(); ++c) total = larger(total, std::abs(moment[c] / volume + sigma[c]));
  const double face = Dim == 2 ? grid.spacing : grid.spacing * grid.spacing;
  return {largest / (scale * face), total / scale};
}

template <int Dim>
Forces forces(const Method& method, const Bench<Dim>& bench, Arrangement arrangement) {
  const int across = Dim == 3 ? 8 : bench.quick ? 16 : 32;
  Setup<Dim> setup = patch_setup(method, bench, across);
  if (arrangement == Arrangement::graded) setup.seeds = graded_seeds<Dim>(across);
  const Stress<Dim> sigma = stress_at<Dim>(*bench.material, homogeneous_deformation<Dim>());
  auto passes = bench.passes(setup);
  insert_after(passes, {Phase::early_stress, Phase::stress}, prescribed_stress<Dim>(sigma));
  Simulation<Dim> simulation(setup, passes);
  State<Dim>& s = simulation.state();
  arrange(s, arrangement);
  fill_stress<Dim>(s, sigma);
  // of all particles, at the beginning of the step
  const Mat<Dim> F = s.template at<Dim * Dim>(Column::deformation_gradient, 0);
  double reference_volume = 0;  // before the step, which may be the one that is wrong
  for (std::size_t p = 0; p < s.particles; ++p) reference_volume += s.column(Column::volume)[p];
  constexpr double no_time = 1e-9;  // in which the body does not move, and a last stage finds it as it was
  if (simulation.step(0, no_time)) return {};
  // In space few nodes are inner ones: half a cell less holds B-splines of degree 4, and all that is not shifted.
  const double margin = Dim == 2 || arrangement == Arrangement::shifted ? 1 : 0.5, J = determinant<Dim>(F);
  Mat<Dim> tensor;
  double scale = 0;
  for (std::size_t c = 0; c < tensor.size(); ++c) tensor[c] = sigma[stress_index<Dim>(c / Dim, c % Dim)];
  if (!method.is_total()) {
    for (const double component : sigma) scale = larger(scale, std::abs(component));
    return summed<Dim>(s, F, margin, tensor, scale, J * reference_volume);
  }
  Mat<Dim> undeformed{};
  for (std::size_t d = 0; d < Dim; ++d) undeformed[d * (Dim + 1)] = 1;
  for (double& component : tensor) component *= J;
  const Mat<Dim> P = product<Dim>(tensor, inverse_transpose<Dim>(F, J));
  for (const double component : P) scale = larger(scale, std::abs(component));
  return summed<Dim>(s, undeformed, margin, P, scale, reference_volume);
}

}  // namespace

template <int Dim>
std::vector<check::TestResult> constant_stress(const Method& method, const Bench<Dim>& bench) {
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
    const Figure figure{found.inner, std::string(what) + ": largest inner force " + digits(found.inner) +
                                         (Dim == 2 ? " of stress times h" : " of stress times h^2")};
    results.push_back(judged(method, id, figure, stress_threshold, "force in a body under constant stress"));
  }
  const Figure figure{total, "sum f x is off by at most " + digits(total) + " of the volume times the stress"};
  results.push_back(judged(method, "stress.total", figure, stress_threshold, "forces do not add up to the stress"));
  return results;
}

template std::vector<check::TestResult> constant_stress(const Method&, const Bench<ASSAY_DIMENSION>&);

}  // namespace assay::mpm
