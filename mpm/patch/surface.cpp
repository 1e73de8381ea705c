// SPDX-License-Identifier: BSD-3-Clause
// A body of constant stress with the tractions that belong to it, none where it is free: the internal force and that of
// the tractions must cancel at all nodes, those of the surface too.
#include <cmath>

#include "harness/motion/kinds/homogeneous.hpp"
#include "harness/numeric/norms.hpp"
#include "mpm/kernels/kernel_state.hpp"
#include "mpm/patch/patch.hpp"
#include "mpm/seeding/lattice.hpp"

namespace assay::mpm {

namespace {

constexpr double balance_threshold = 1e-12;  ///< rounding: at most 2e-14 is found
constexpr double tension = 1.3;              ///< principal stretch between the loaded ends [1]

/// Stretched along the axes: E_1, and the others.
template <int Dim>
Mat<Dim> stretched(double along, double across) {
  Mat<Dim> F{};
  for (std::size_t d = 0; d < Dim; ++d) F[d * (Dim + 1)] = d == 0 ? along : across;
  return F;
}

/// The stretch across at which nothing presses on the sides. sigma_22 grows with it.
template <int Dim>
double free_stretch(const Material& material) {
  double lower = 0.5, upper = 1.5;
  for (;;) {
    const double middle = 0.5 * (lower + upper);
    if (middle <= lower || middle >= upper) return middle;
    const auto sigma = stress_at<Dim>(material, stretched<Dim>(tension, middle));
    (sigma[stress_index<Dim>(1, 1)] < 0 ? lower : upper) = middle;
  }
}

/// A body, its deformation and its loads.
template <int Dim>
struct Loading {
  Mat<Dim> F{};
  bool free_sides = false;     ///< tractions on the faces across E_1 alone
  bool fits_deformed = false;  ///< F stretches it to the grid's cells, else away from them
  TractionForm form = TractionForm::reference;
};

/// The lattice that F, a stretch along the axes, makes that of the seeds.
template <int Dim>
void unstretch(Seeds<Dim>& seeds, Vec<Dim>& half, const Mat<Dim>& F) {
  for (std::size_t d = 0; d < Dim; ++d) {
    const double stretch = F[d * (Dim + 1)];
    for (double& X : seeds.X[d]) X /= stretch;
    seeds.half_size[d] /= stretch;
    half[d] /= stretch;
  }
}

template <int Dim>
ExactSolutionPtr solution_of(const Bench<Dim>& bench, const Mat<Dim>& F) {
  Homogeneous motion;
  for (int c = 0; c < Dim * Dim; ++c) motion.final(c / Dim, c % Dim) = F[static_cast<std::size_t>(c)];
  constexpr double tolerance = 1e-12;  // of a history, which an elastic material has none of
  return exact_uniform(motion, bench.density, bench.material, motion.baseline(), motion.period, tolerance);
}

template <int Dim>
Setup<Dim> loaded_setup(const Method& method, const Bench<Dim>& bench, const Loading<Dim>& loading) {
  Setup<Dim> setup = patch_setup(method, bench, cells_across(bench));
  Seeds<Dim>& seeds = setup.seeds;
  Vec<Dim> half;
  half.fill(0.5);
  if (loading.fits_deformed) unstretch<Dim>(seeds, half, loading.F);
  BoxOfAxes<Dim> body, domain;
  for (std::size_t d = 0; d < Dim; ++d) body.lower[d] = -half[d], body.upper[d] = half[d];
  for (std::size_t p = 0; p < seeds.size(); ++p) {
    for (std::size_t d = 0; d < Dim; ++d) {
      domain.lower[d] = seeds.X[d][p] - seeds.half_size[d];
      domain.upper[d] = seeds.X[d][p] + seeds.half_size[d];
    }
    add_surface_edges<Dim>(body, {}, domain, static_cast<std::uint32_t>(p), seeds.surface);
  }
  if (loading.free_sides) std::erase_if(seeds.surface, [](const auto& piece) { return piece.N_dA[0] == 0; });
  setup.traction = Traction{TractionAlgorithm::edges, loading.form};
  setup.exact = solution_of<Dim>(bench, loading.F);
  return setup;
}

/// As the motion has left it: x = F X, the corners too, and the stress of F.
template <int Dim>
void load_body(State<Dim>& s, const Mat<Dim>& F) {
  const auto sigma = stress_at<Dim>(*s.setup.material, F);
  const auto map = [&](Column column, std::size_t first, std::size_t p) {
    Vec<Dim> X;
    for (std::size_t d = 0; d < Dim; ++d) X[d] = s.column(column, first + d)[p];
    X = image_of<Dim>(F, X);
    for (std::size_t d = 0; d < Dim; ++d) s.column(column, first + d)[p] = X[d];
  };
  for (std::size_t p = 0; p < s.particles; ++p) {
    map(Column::position, 0, p);
    for (std::size_t c = 0; c < F.size(); ++c) s.column(Column::deformation_gradient, c)[p] = F[c];
    for (std::size_t c = 0; c < sigma.size(); ++c) s.column(Column::stress, c)[p] = sigma[c];
    for (std::size_t c = 0; s.has(Column::corners) && c < (Dim << Dim); c += Dim) map(Column::corners, c, p);
  }
}

/// The largest force at any node, over the stress and h, in space h^2: P in the reference configuration, else Cauchy's.
template <int Dim>
double imbalance(const Method& method, const Bench<Dim>& bench, const Loading<Dim>& loading) {
  const Setup<Dim> setup = loaded_setup(method, bench, loading);
  Simulation<Dim> simulation(setup, bench.passes(setup));
  State<Dim>& s = simulation.state();
  load_body<Dim>(s, loading.F);
  const double t = setup.exact->motion()->period();
  constexpr double no_time = 1e-30;  // t and that are t: the tractions are those of F in every update
  if (simulation.step(t, no_time)) return INFINITY;
  const ExactStress stress = setup.exact->at(Vector3::Zero(), t).stress;
  const Tensor& scale = method.is_total() ? stress.first_piola_kirchhoff : stress.cauchy;
  double largest = 0;
  for (std::size_t i = 0; i < s.force.nodes(); ++i) {
    for (std::size_t d = 0; d < Dim; ++d) {
      const double force = std::abs(s.force.node(i)[d]);
      if (!std::isfinite(force)) return INFINITY;
      largest = larger(largest, force);
    }
  }
  const double h = setup.grid.spacing, face = Dim == 2 ? h : h * h;
  return largest / (scale.topLeftCorner<Dim, Dim>().cwiseAbs().maxCoeff() * face);
}

}  // namespace

template <int Dim>
std::vector<check::TestResult> surface(const Method& method, const Bench<Dim>& bench) {
  const Mat<Dim> pulled = stretched<Dim>(tension, free_stretch<Dim>(*bench.material));
  const double free = imbalance<Dim>(method, bench, {pulled, true, !method.is_total()});
  const Mat<Dim> F = homogeneous_deformation<Dim>();
  const double reference = imbalance<Dim>(method, bench, {F, false, false, TractionForm::reference});
  const double follower = imbalance<Dim>(method, bench, {F, false, false, TractionForm::follower});
  const std::string off = Dim == 2 ? " of stress times h at any node" : " of stress times h^2 at any node";
  return {judged(method, "surface.free",
                 {free, "tension between two ends, sides free: the force is at most " + digits(free) + off},
                 balance_threshold, "force at a loaded or free face under constant stress"),
          judged(method, "surface.traction",
                 {larger(reference, follower), "stretched and sheared, loaded all round: the force is at most " +
                                                   digits(reference) + " by P N dA0 and " + digits(follower) +
                                                   " by sigma n ds" + off},
                 balance_threshold, "force at a loaded face under constant stress")};
}

template std::vector<check::TestResult> surface(const Method&, const Bench<ASSAY_DIMENSION>&);

}  // namespace assay::mpm
