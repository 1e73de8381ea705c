// SPDX-License-Identifier: BSD-3-Clause
// What a run of a scene may ask for: sizes, times, memory.
#include "drivers/simulation/problem.hpp"

#include "drivers/scene/body_box.hpp"
#include "drivers/simulation/body_faces.hpp"
#include "drivers/simulation/units_hint.hpp"
#include "drivers/text/numbers.hpp"
#include "harness/motion/kinds/deformation_table.hpp"
#include "harness/motion/kinds/vortex3d.hpp"

namespace assay::drivers {

namespace {

constexpr double most_snapshots = 1e5;  ///< of every step

/// Updates of the histories under a sheet, a period of the motion: of Zener's model at a tolerance of 0.01, the least
/// that was measured. Plasticity takes 2 to 12 times as many.
constexpr double sheet_updates = 5e4;

/// Material points that are marched for the response before or beside the particles, times their steps.
double history_steps(const PosedScene& problem) {
  const Scene& scene = problem.scene;
  if (!problem.compared || !(ring_of(scene.motion) || scene.motion.as<Vortex3d>())) return 0;
  using enum ForceChoice::Response;
  if (scene.force.response == shadow) return static_cast<double>(problem.steps) * scene.force.radii;
  if (scene.force.response != sheet) return 0;
  if (problem.material->path_independent() && baseline_path(scene).straight()) return 0;
  return sheet_updates * scene.time.end / problem.period();
}

}  // namespace

void require_acceleration(const Scene& scene) {
  const auto* table = scene.motion.as<DeformationTable>();
  if (!table || table->interpolation() != Interpolation::linear) return;
  refuse(scene, "motion.interpolation",
         "linear makes the velocity jump at the rows, but the body force needs the second derivative of F: "
         "only tabulate accepts linear",
         "monotone, spline");
}

void require_runnable(const Scene& scene) {
  require_acceleration(scene);
  if (scene.force.quasi_static)
    refuse(scene, "force.quasi_static", "leaves the inertia out, which every run has: it serves eval, for other codes");
  if (!scene.method)
    refuse(scene, "method", "a scene without a method cannot be run: only tabulated, evaluated and checked");
  if (scene.dimension == 2 && !scene.motion->is_plane()) {
    refuse(scene, "motion",
           "the method is plane strain: nothing may happen out of the plane, and axes must be [0, 0, 1]; or take "
           "dimension: 3");
  }
  const bool turns = is_vortex(scene.motion) || scene.motion.as<Vortex3d>();
  const Amplitude* amplitude = turns ? scene.motion->amplitude() : nullptr;
  if (amplitude && amplitude->type == Amplitude::Type::ramp && scene.time.end > amplitude->period) {
    refuse(scene, "time.end",
           "a ramp stops at its period: the velocity jumps there, and no body force can do that; end the run "
           "at the period");
  }
  if (!scene.grid) refuse(scene, "grid", "required to run");
  require_surface(scene);
}

/// Before a lattice and a grid are made: whether their sizes alone are out of all bounds.
template <int Dim>
void check_sizes(const Scene& scene) {
  constexpr double most = 2e9;  // particles and nodes are counted in 32 bits
  const GridChoice& grid = *scene.grid;
  const auto body = body_box<Dim>(scene), swept = swept_box<Dim>(scene);
  double particles = 1, nodes = 1;
  for (std::size_t d = 0; d < Dim; ++d) {
    particles *= (body.upper[d] - body.lower[d]) / grid.spacing * scene.body.per_cell[d];
    const double width = grid.lower ? (*grid.upper)[d] - (*grid.lower)[d] : swept.upper[d] - swept.lower[d];
    nodes *= width / grid.spacing + 2 * grid_margin + 2;
  }
  const auto check = [&](double count, double bytes_each, const std::string& key, const std::string& what) {
    const double gib = count * bytes_each / (1024.0 * 1024 * 1024);
    if (gib <= scene.limits.memory_gib && count < most) return;
    refuse(scene, key,
           "makes about " + rounded_text(count, 3) + " " + what +
               ": more than limits.memory_gib = " + rounded_text(scene.limits.memory_gib, 6) + " can hold");
  };
  check(particles, Dim * sizeof(double), "grid.spacing", "particles");
  check(nodes, 9 * sizeof(double), grid.lower ? "grid.upper" : "grid.spacing", "grid nodes");
}

/// Stages of a step go back in time, which only a stress that follows from F alone can do with them.
void require_reversible(const Scene& scene, const Material& material) {
  if (!scene.method->has_stages() || material.is_function_of_F()) return;
  refuse(scene, "method.integrator",
         "symplectic_rkn4 goes back in time within a step, and the stress of '" + material.name() +
             "' is not a function of F alone: it has a history or a rate",
         "symplectic_euler, leapfrog");
}

void require_few_periods(const Scene& scene, const Material& material) {
  constexpr double most_periods = 10'000;
  const bool followed = scene.force.response != ForceChoice::Response::none && !material.is_function_of_F();
  if (!followed || scene.time.end <= most_periods * scene.motion->period()) return;
  refuse(scene, "time.end",
         "histories are followed over at most " + rounded_text(most_periods, 6) +
             " periods of the motion, whose T is " + scene.units.text(scene.motion->period(), "s", 6));
}

template <int Dim>
void check_limits(const ProblemIn<Dim>& problem) {
  const Scene& scene = problem.scene;
  const double gib = problem.estimated_bytes() / (1024.0 * 1024 * 1024);
  if (gib > scene.limits.memory_gib) {
    refuse(scene, "limits.memory_gib",
           "the run would need " + rounded_text(gib, 3) + " GiB, the limit is " +
               rounded_text(scene.limits.memory_gib, 6));
  }
  const double of_histories = history_steps(problem);
  const double particle_steps =
      static_cast<double>(problem.steps) * static_cast<double>(problem.setup.seeds.size()) + of_histories;
  if (scene.output.each_step_from && *scene.output.each_step_from < scene.time.end) {
    const double shots = (scene.time.end - *scene.output.each_step_from) / problem.dt;
    if (shots > most_snapshots) {
      refuse(scene, "output.each_step_from",
             "asks for " + rounded_text(shots, 3) + " snapshots, at most " + rounded_text(most_snapshots, 6) +
                 " are written");
    }
  }
  if (particle_steps > scene.limits.particle_steps) {
    const std::string hint = units_hint(problem);
    refuse(scene, "limits.particle_steps",
           "the run would take " + rounded_text(particle_steps, 3) + " particle-steps" +
               (of_histories > 0 ? ", those of the response's histories included" : "") + ", the limit is " +
               rounded_text(scene.limits.particle_steps, 6) + (hint.empty() ? "" : ": " + hint));
  }
}

template void check_sizes<2>(const Scene&);
template void check_sizes<3>(const Scene&);
template void check_limits(const ProblemIn<2>&);
template void check_limits(const ProblemIn<3>&);

}  // namespace assay::drivers
