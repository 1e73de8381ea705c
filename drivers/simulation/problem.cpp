// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/problem.hpp"

#include <algorithm>
#include <cmath>

#include "drivers/material/material_choice.hpp"
#include "drivers/scene/body_box.hpp"
#include "drivers/scene/scene_keys.hpp"
#include "drivers/simulation/body_faces.hpp"
#include "drivers/simulation/time_steps.hpp"
#include "drivers/simulation/warnings.hpp"
#include "drivers/system/terminal.hpp"
#include "drivers/text/numbers.hpp"
#include "harness/motion/kinds/axis_aligned.hpp"
#include "harness/motion/kinds/vortex3d.hpp"
#include "mpm/seeding/lattice.hpp"

namespace assay::drivers {

namespace {

template <int Dim>
mpm::GridGeometry<Dim> grid_around(const BoxOf<Dim>& box, const GridChoice& choice, int margin) {
  BoxOf<Dim> by_nodes = box;
  for (std::size_t d = 0; d < Dim; ++d) {
    by_nodes.lower[d] -= choice.offset[d] * choice.spacing;
    by_nodes.upper[d] -= choice.offset[d] * choice.spacing;
  }
  mpm::GridGeometry<Dim> grid = mpm::grid_around(by_nodes.lower, by_nodes.upper, choice.spacing, margin);
  grid.offset = choice.offset;
  return grid;
}

template <int Dim>
mpm::GridGeometry<Dim> grid_of(const Scene& scene) {
  const GridChoice& grid = *scene.grid;
  const BoxOf<Dim> body = swept_box<Dim>(scene);
  if (!grid.lower) return grid_around(body, grid, grid_margin);
  const BoxOf<Dim> given{*grid.lower, *grid.upper};
  for (std::size_t d = 0; d < Dim; ++d) {
    if (given.lower[d] > body.lower[d] || given.upper[d] < body.upper[d]) {
      const auto text = [](const auto& corner) {
        return "[" + joined(corner, [](double x) { return rounded_text(x, 6); }) + "]";
      };
      refuse(scene, "grid",
             "particles of the body lie outside the grid, whose corners are " + text(given.lower) + " and " +
                 text(given.upper));
    }
  }
  const int across = mpm::traits_of<Dim>(scene.method->basis).nodes_across;
  int margin = 1;  // one cell for the domains at the edge, and as many nodes as a particle reaches over
  mpm::GridGeometry<Dim> found = grid_around(given, grid, margin);
  while (*std::min_element(found.count.begin(), found.count.end()) < across) found = grid_around(given, grid, ++margin);
  return found;
}

/// c = sqrt(E/rho0) of a motion in the unit box that does not say it, and the end of the run that follows from it.
void resolve_wave_speed(Scene& scene) {
  auto* box = scene.motion.as<AxisAligned>();
  if (!box || box->given_speed) return;
  const auto modulus = scene.material.parameters.find("E");
  if (modulus == scene.material.parameters.end() || !(modulus->second > 0)) {
    refuse(scene, "motion.wave_speed",
           "auto takes sqrt(E/rho0), and the material has no parameter E above 0: give it [" + scene.units.name("m/s") +
               "]");
  }
  const double speed = std::sqrt(modulus->second / scene.material.density);
  if (!(speed >= AxisAligned::least_wave_speed && speed <= AxisAligned::most_wave_speed)) {
    refuse(scene, "motion.wave_speed",
           "auto takes sqrt(E/rho0), which is " + scene.units.text(speed, "m/s", 3) + ", beyond " +
               scene.units.text(speed > 1 ? AxisAligned::most_wave_speed : AxisAligned::least_wave_speed, "m/s", 3) +
               ": give it");
  }
  box->amplitude.period = 1 / speed;
  box->given_speed = true;
  if (!scene.places.contains("time.end")) scene.time.end = box->amplitude.period;
}

/// Body force, tractions, and what the body's other faces are.
template <int Dim>
void choose_forces(ProblemIn<Dim>& problem) {
  Scene& scene = problem.scene;
  mpm::Setup<Dim>& setup = problem.setup;
  const bool forced = scene.force.response != ForceChoice::Response::none;
  const bool spins = scene.frame && scene.frame->spin != 0;  // Coriolis' and the centrifugal force act on any motion
  setup.body_force = forced && (scene.motion->accelerates() || spins);
  problem.compared = forced;
  setup.traction = traction_of(scene);
  if (!setup.traction) setup.seeds.surface.clear();
  const bool on_faces = setup.traction && setup.traction->algorithm != mpm::TractionAlgorithm::virtual_stress;
  if (on_faces && setup.seeds.surface.empty()) {
    if (scene.output.tractions) {
      refuse(scene, "output.tractions",
             "compares tractions, and all faces of the body are symmetry planes or periodic ends");
    }
    setup.traction.reset();
  }
  setup.ends = ends_of<Dim>(scene);
  if (setup.has_images() && setup.grid.offset != std::array<double, Dim>{}) {
    refuse(scene, "grid.offset",
           "symmetry planes and periodic ends of the body lie on nodes, which an offset takes away from them");
  }
  // a force that is linear in X is on a domain what it is in its middle; at Gauss points their rule takes the mean
  const bool by_rule =
      !ring_of(scene.motion) && !scene.motion.as<Vortex3d>() && scene.body.lattice == Body::Lattice::gauss;
  const bool pointwise = scene.motion->is_homogeneous() || by_rule;
  setup.evaluation = pointwise ? mpm::Evaluation::point : scene.force.evaluation;
  setup.inertia = scene.force.inertia;
}

}  // namespace

std::shared_ptr<const Material> material_of(Scene& scene, std::string& library) {
  ResolvedMaterial resolved = resolve_material(scene);
  for (const std::string& sentence : resolved.warnings) warn(sentence);
  scene.material = std::move(resolved.choice);
  library = std::move(resolved.library);
  // Histories of its increments converge slowly: to 1e-8 they take minutes, and errors of a method are far larger.
  constexpr double tolerance_of_foreign = 1e-5;
  if (resolved.foreign && !scene.places.contains("force.tolerance")) scene.force.tolerance = tolerance_of_foreign;
  resolve_wave_speed(scene);
  return std::make_shared<const Material>(std::move(resolved.material));
}

template <int Dim>
ProblemIn<Dim> assemble(const Scene& given, int threads) {
  ProblemIn<Dim> problem;
  problem.scene = given;
  Scene& scene = problem.scene;
  require_runnable(scene);
  check_sizes<Dim>(scene);
  problem.material = material_of(scene, problem.library);
  require_reversible(scene, *problem.material);
  require_few_periods(scene, *problem.material);
  mpm::Setup<Dim>& setup = problem.setup;
  setup.method = *scene.method;
  setup.grid = grid_of<Dim>(scene);
  setup.seeds = seeds_of<Dim>(scene);
  mpm::order_by_nodes(setup);
  setup.density = scene.material.density;
  setup.material = problem.material;
  choose_forces(problem);
  setup.motion = scene.motion;
  setup.frame = scene.frame;
  if constexpr (Dim == 2) {
    if (const auto& v = scene.body.initial_velocity) setup.initial_velocity = {v->velocity, v->gradient()};
  }
  setup.hold_outside = !scene.body.is_vortex_alone() && scene.body.outside == Body::Outside::held;
  setup.accounts = scene.output.accounts;
  setup.options = scene.effects;
  setup.threads = threads;
  if (setup.seeds.size() == 0) refuse(scene, "grid.spacing", no_particle_sentence(problem));
  for (const Path& path : baseline_paths(scene)) setup.material_direction = path.material_direction;
  const Tensor turn = scene.frame ? scene.frame->rotation(0) : Tensor(Tensor::Identity());
  setup.initial_cauchy = turn * scene.initial_cauchy() * turn.transpose();
  find_speeds(problem);
  plan_steps(problem);
  check_limits(problem);
  return problem;
}

template ProblemIn<2> assemble<2>(const Scene&, int);
template ProblemIn<3> assemble<3>(const Scene&, int);

}  // namespace assay::drivers
