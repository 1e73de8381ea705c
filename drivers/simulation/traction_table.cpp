// SPDX-License-Identifier: BSD-3-Clause
// The algorithms of tractions side by side.
#include <chrono>
#include <cmath>

#include "drivers/scene/body_box.hpp"
#include "drivers/simulation/response_source.hpp"
#include "drivers/simulation/simulate.hpp"
#include "drivers/system/progress.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/words.hpp"
#include "harness/motion/kinds/homogeneous.hpp"

namespace assay::drivers {

namespace {

using mpm::TractionAlgorithm;

/// From the one that fails to the one that is told most.
constexpr TractionAlgorithm compared_algorithms[] = {TractionAlgorithm::undeformed_edges, TractionAlgorithm::particles,
                                                     TractionAlgorithm::edges, TractionAlgorithm::virtual_stress};

/// Whether the body consists of whole cells of a grid of this spacing; a ring's faces cut those of any.
bool divides_body(const Scene& scene, double spacing) {
  if (scene.body.is_vortex_alone()) return true;
  constexpr double rounding = 1e-9;  // of a cell
  for (const auto& corner : {scene.body.lower, scene.body.upper}) {
    for (std::size_t d = 0; d < corner.size(); ++d) {
      if (std::abs(corner[d] / spacing - std::round(corner[d] / spacing)) > rounding) return false;
    }
  }
  return true;
}

std::vector<double> spacings_of(const Scene& scene) {
  const double h = scene.grid->spacing;
  std::vector<double> found;
  for (const double coarser : {4 * h, 2 * h}) {
    if (divides_body(scene, coarser)) found.push_back(coarser);
  }
  found.push_back(h);
  return found;
}

/// The scene with another algorithm on another grid, and nothing that is written or need not be known.
Scene variant_of(const Scene& scene, TractionAlgorithm algorithm, double spacing) {
  Scene other = scene;
  other.grid->spacing = spacing;
  other.traction.algorithm = algorithm;
  if (!scene.places.contains("traction.form")) other.traction.form.reset();  // filled in for the scene's own algorithm
  other.output = {.errors = scene.output.errors, .particles = 0, .pictures = false, .report = false, .accounts = false};
  return other;
}

void take_figures(const Result& result, TractionRun& run) {
  run.outcome = result.outcome;
  run.t = result.t;
  run.l2_end = result.error.l2_end;
  run.l2_max = result.error.l2_max;
}

template <int Dim>
void name_form(const ProblemIn<Dim>& problem, TractionRun& run) {
  const auto& traction = problem.setup.traction;
  if (!traction || traction->algorithm == TractionAlgorithm::undeformed_edges) return;
  run.form = word_of(traction->form);
}

/// What a scene's variant finds. One that cannot be run, as it would exceed the limits, is refused alone.
template <int Dim>
void run_variant(const Scene& scene, int threads, OutputFolder& folder, bool quiet, TractionRun& run) {
  Result result;
  try {
    ProblemIn<Dim> problem = assemble<Dim>(scene, threads);
    name_form(problem, run);
    const auto exact = exact_solution_of(problem.scene, problem.material, problem.scene.time.end, {.threads = threads});
    Snapshots nothing(problem, folder);
    Progress progress(run.algorithm + ", " + scene.units.text(run.spacing, "m", 3), quiet);
    simulate(problem, exact, nothing, progress, result);
  } catch (const InputError&) {
    result.outcome = "refused";
  }
  take_figures(result, run);
}

}  // namespace

bool is_table_1(const PosedScene& problem) {
  const Scene& scene = problem.scene;
  const auto* motion = scene.motion.as<Homogeneous>();
  if (!motion || motion->final != Tensor(Vector3(2, 1, 1).asDiagonal()) || motion->period != 1) return false;
  const Body& body = scene.body;
  const std::array<double, 2> origin{0, 0}, far{1, 1};
  if (scene.dimension != 2 || body.lower.in<2>() != origin || body.upper.in<2>() != far) return false;
  if (body.per_cell.in<2>() != std::array<int, 2>{2, 2} || body.lattice != Body::Lattice::cartesian) return false;
  const MaterialChoice& material = scene.material;
  return problem.material->name() == "neo_hookean" && problem.library.empty() && material.density == 1000 &&
         material.parameters.at("E") == 1e6 && material.parameters.at("nu") == 0.25 && scene.time.end == 1;
}

template <int Dim>
TractionTable traction_table(const ProblemIn<Dim>& problem, const Result& own, OutputFolder& folder, bool quiet) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  const Scene& scene = problem.scene;
  const auto body = body_box<Dim>(scene);
  TractionTable table;
  table.of_paper = is_table_1(problem);
  for (const TractionAlgorithm algorithm : compared_algorithms) {
    for (const double spacing : spacings_of(scene)) {
      TractionRun run{word_of(algorithm), {}, spacing, {}, {}, {}, {}, {}};
      for (std::size_t d = 0; d < Dim; ++d) run.cells[d] = (body.upper[d] - body.lower[d]) / spacing;
      run.exact = algorithm == TractionAlgorithm::virtual_stress || scene.force.inertia == mpm::Inertia::particles;
      run.own = algorithm == scene.traction.algorithm;
      if (run.own && spacing == scene.grid->spacing) {
        name_form(problem, run);
        take_figures(own, run);
      } else {
        run_variant<Dim>(variant_of(scene, algorithm, spacing), problem.setup.threads, folder, quiet, run);
      }
      table.runs.push_back(std::move(run));
    }
  }
  table.wall_s = std::chrono::duration<double>(Clock::now() - start).count();
  return table;
}

template TractionTable traction_table(const ProblemIn<2>&, const Result&, OutputFolder&, bool);
template TractionTable traction_table(const ProblemIn<3>&, const Result&, OutputFolder&, bool);

}  // namespace assay::drivers
