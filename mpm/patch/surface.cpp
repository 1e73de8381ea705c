// SPDX-License-Identifier: BSD-3-Clause
// A body of constant stress with the tractions that belong to it, none where it is free: the internal force and that of
// the tractions must cancel at all nodes, those of the surface too.
#include <cmath>

#include "harness/motion/kinds/homogeneous.hpp"
#include "harness/numeric/norms.hpp"
#include "mpm/patch/patch.hpp"
#include "mpm/seeding/lattice.hpp"

namespace assay::mpm {

namespace {

constexpr double balance_threshold = 1e-12;  ///< rounding: at most 2e-14 is found
constexpr double tension = 1.3;              ///< principal stretch between the loaded ends [1]
constexpr Vec<2> half_body{0.5, 0.5};        ///< of `patch_setup` [m]

/// The stretch across at which nothing presses on the sides. sigma_22 grows with it.
double free_stretch(const Material& material) {
  double lower = 0.5, upper = 1.5;
  for (;;) {
    const double middle = 0.5 * (lower + upper);
    if (middle <= lower || middle >= upper) return middle;
    (stress_at(material, {tension, 0, 0, middle})[3] < 0 ? lower : upper) = middle;
  }
}

/// A body, its deformation and its loads.
struct Loading {
  Mat<2> F{1, 0, 0, 1};
  bool free_sides = false;     ///< tractions on the faces across E_1 alone
  bool fits_deformed = false;  ///< F stretches it to the grid's cells, else away from them
  TractionForm form = TractionForm::reference;
};

/// The lattice that F, a stretch along the axes, makes that of the seeds.
void unstretch(Seeds<2>& seeds, Vec<2>& half, const Mat<2>& F) {
  for (std::size_t d = 0; d < 2; ++d) {
    for (double& X : seeds.X[d]) X /= F[3 * d];
    seeds.half_size[d] /= F[3 * d];
    half[d] /= F[3 * d];
  }
}

ExactSolutionPtr solution_of(const Bench& bench, const Mat<2>& F) {
  Homogeneous motion;
  motion.final.topLeftCorner<2, 2>() << F[0], F[1], F[2], F[3];
  constexpr double tolerance = 1e-12;  // of a history, which an elastic material has none of
  return exact_uniform(motion, bench.density, bench.material, motion.baseline(), motion.period, tolerance);
}

Setup<2> loaded_setup(const Method& method, const Bench& bench, const Loading& loading) {
  Setup<2> setup = patch_setup(method, bench, bench.quick ? 8 : 32);
  Seeds<2>& seeds = setup.seeds;
  Vec<2> half = half_body;
  if (loading.fits_deformed) unstretch(seeds, half, loading.F);
  const Rectangle body{{-half[0], -half[1]}, half};
  for (std::size_t p = 0; p < seeds.size(); ++p) {
    const double X = seeds.X[0][p], Y = seeds.X[1][p], width = seeds.half_size[0], height = seeds.half_size[1];
    add_surface_edges<2>(body, {}, {{X - width, Y - height}, {X + width, Y + height}}, static_cast<std::uint32_t>(p),
                         seeds.surface);
  }
  if (loading.free_sides) std::erase_if(seeds.surface, [](const SurfaceEdge& edge) { return edge.N_dA[0] == 0; });
  setup.traction = Traction{TractionAlgorithm::edges, loading.form};
  setup.exact = solution_of(bench, loading.F);
  return setup;
}

/// As the motion has left it: x = F X, the corners too, and the stress of F.
void load_body(State<2>& s, const Mat<2>& F) {
  const auto sigma = stress_at(*s.setup.material, F);
  const auto map = [&](double& x, double& y) {
    const Vec<2> X{x, y};
    x = F[0] * X[0] + F[1] * X[1];
    y = F[2] * X[0] + F[3] * X[1];
  };
  for (std::size_t p = 0; p < s.particles; ++p) {
    map(s.column(Column::position, 0)[p], s.column(Column::position, 1)[p]);
    for (int c = 0; c < 4; ++c) s.column(Column::deformation_gradient, c)[p] = F[static_cast<std::size_t>(c)];
    for (int c = 0; c < 5; ++c) s.column(Column::stress, c)[p] = sigma[static_cast<std::size_t>(c)];
    for (int c = 0; s.has(Column::corners) && c < 8; c += 2)
      map(s.column(Column::corners, c)[p], s.column(Column::corners, c + 1)[p]);
  }
}

/// The largest force at any node, over h times the stress: P in the reference configuration, else Cauchy's.
double imbalance(const Method& method, const Bench& bench, const Loading& loading) {
  const Setup<2> setup = loaded_setup(method, bench, loading);
  Simulation<2> simulation(setup, bench.passes(setup));
  State<2>& s = simulation.state();
  load_body(s, loading.F);
  const double t = setup.exact->motion()->period();
  constexpr double no_time = 1e-30;  // t and that are t: the tractions are those of F in every update
  if (simulation.step(t, no_time)) return INFINITY;
  const ExactStress stress = setup.exact->at(Vector3::Zero(), t).stress;
  const Tensor& scale = method.is_total() ? stress.first_piola_kirchhoff : stress.cauchy;
  double largest = 0;
  for (std::size_t i = 0; i < s.force.nodes(); ++i) {
    for (std::size_t d = 0; d < 2; ++d) {
      const double force = std::abs(s.force.node(i)[d]);
      if (!std::isfinite(force)) return INFINITY;
      largest = larger(largest, force);
    }
  }
  return largest / (scale.topLeftCorner<2, 2>().cwiseAbs().maxCoeff() * setup.grid.spacing);
}

}  // namespace

std::vector<check::TestResult> surface(const Method& method, const Bench& bench) {
  const Mat<2> pulled{tension, 0, 0, free_stretch(*bench.material)};
  const double free = imbalance(method, bench, {pulled, true, !method.is_total()});
  const Mat<2> F = homogeneous_deformation();
  const double reference = imbalance(method, bench, {F, false, false, TractionForm::reference});
  const double follower = imbalance(method, bench, {F, false, false, TractionForm::follower});
  const std::string off = " of stress times h at any node";
  return {judged(method, "surface.free",
                 {free, "tension between two ends, sides free: the force is at most " + digits(free) + off},
                 balance_threshold, "force at a loaded or free face under constant stress"),
          judged(method, "surface.traction",
                 {larger(reference, follower), "stretched and sheared, loaded all round: the force is at most " +
                                                   digits(reference) + " by P N dA0 and " + digits(follower) +
                                                   " by sigma n ds" + off},
                 balance_threshold, "force at a loaded face under constant stress")};
}

}  // namespace assay::mpm
