// SPDX-License-Identifier: BSD-3-Clause
// From a scene to what targets write: its exact solution, its grids and their seeds.
#include <algorithm>

#include "drivers/export/export.hpp"
#include "drivers/export/grids.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/problem.hpp"
#include "drivers/simulation/response_source.hpp"
#include "drivers/simulation/warnings.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/text/sha256.hpp"
#include "harness/exact/places.hpp"
#include "harness/motion/kinds/vortex.hpp"
#include "harness/stability/wave_speed.hpp"

namespace assay::drivers {

namespace {

/// The jump of b of power 2 costs a nodal method its order.
constexpr int smooth_power = 4;
constexpr double wave_periods = 4;  ///< in which the fastest wave is looked for, as by a run

Scene exported_scene(const ExportOptions& options, std::vector<std::string>& remarks) {
  Scene scene = read_scene(options.scene, options.sets);
  scene.expect.clear();  // what a run of assay is to find
  if (options.quasi_static) scene.force.quasi_static = true;
  if (scene.force.response == ForceChoice::Response::none) scene.force.response = ForceChoice::Response::sheet;
  auto* ring = scene.motion.as<Vortex>();
  if (ring && !scene.places.contains("motion.profile_power")) {
    ring->profile_power = smooth_power;
    remarks.emplace_back(
        "profile_power is 4, because the scene gives none: with 2 the body force jumps at the edges of the ring, and a "
        "nodal method has order 1. With motion.profile_power: 2 the scene asks for the jump");
  }
  return scene;
}

void put_velocities(ExportedGrid& grid, const ExportedProblem& problem) {
  grid.v0.assign(grid.size(), Vector3::Zero());
  if (problem.quasi_static) return;
  for (std::size_t k = 0; k < grid.size(); ++k) grid.v0[k] = problem.exact->state(grid.X[k], 0).v;
}

}  // namespace

std::string refusal_of_loaded_surface(const ExportedProblem& problem) {
  if (!problem.bears_tractions) return {};
  return "the surface of this body bears tractions, which this target does not write: use --to csv or nodal-loads";
}

ExportedProblem export_problem(const ExportOptions& options, const Target& target) {
  ExportedProblem problem;
  problem.scene = exported_scene(options, problem.remarks);
  Scene& scene = problem.scene;
  require_acceleration(scene);
  if (!scene.initial_cauchy().isZero(0))
    refuse(scene, "material.initial_stress", "is not written for other codes: their bodies begin without stress");
  problem.dimension = scene.dimension == 3 || !scene.motion->is_plane() ? 3 : 2;
  problem.quasi_static = scene.force.quasi_static;
  problem.period = scene.motion->period(), problem.end = scene.time.end;
  problem.bears_tractions = scene.motion->bears_tractions();
  problem.rests_at_edge = !problem.bears_tractions && !scene.motion->is_homogeneous();
  const ExportedBody body = exported_body(scene, problem.dimension);
  const std::vector<double> ladder = spacings_of_ladder(options.grids, scene, body, problem.dimension);
  std::string library;
  problem.material = material_of(scene, library);
  problem.density = scene.material.density;
  for (const double h : ladder)
    problem.grids.push_back(grid_of(h, body, problem.dimension, problem.density, target.seeds));
  if (const std::string why = target.refusal ? target.refusal(problem) : ""; !why.empty())
    throw InputError({options.scene, 0, 0}, "--to " + std::string(target.name), why);
  problem.scene_yaml = resolved_yaml(scene);
  problem.scene_sha256 = sha256_hex(problem.scene_yaml);
  warn_of_instability(scene, *problem.material, problem.end, options.quiet());
  problem.exact = exact_solution_of_points(scene, problem.material, problem.end, options.quiet());
  for (const Path& path : baseline_paths(scene))
    problem.wave_speed =
        std::max(problem.wave_speed, fastest_wave_on_path(*problem.material, path, problem.density,
                                                          std::min(problem.end, wave_periods * problem.period)));
  for (ExportedGrid& grid : problem.grids) {
    stop_if_interrupted();
    put_velocities(grid, problem);
  }
  return problem;
}

}  // namespace assay::drivers
