// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/problem.hpp"

#include <algorithm>
#include <cmath>

#include "drivers/material/material_choice.hpp"
#include "drivers/scene/body_box.hpp"
#include "drivers/scene/scene_keys.hpp"
#include "drivers/simulation/body_faces.hpp"
#include "drivers/simulation/time_steps.hpp"
#include "drivers/system/terminal.hpp"
#include "drivers/text/numbers.hpp"
#include "harness/motion/kinds/axis_aligned.hpp"
#include "mpm/basis/corners.hpp"
#include "mpm/patch/methods.hpp"
#include "mpm/seeding/lattice.hpp"

namespace assay::drivers {

namespace {

constexpr double cell_bytes = 420, sector_bytes = 90;  ///< that averaging over a particle's domain takes (measured)
constexpr double spin_bytes = 120;  ///< that a spinning frame's force takes, its means included (counted)
constexpr double inertia_bytes =
    92;  ///< that giving particles their inertia takes where no two radii are equal (counted)

mpm::GridGeometry<2> grid_around(const Box& box, const GridChoice& choice, int margin) {
  Box by_nodes = box;
  for (std::size_t d = 0; d < 2; ++d) {
    by_nodes.lower[d] -= choice.offset[d] * choice.spacing;
    by_nodes.upper[d] -= choice.offset[d] * choice.spacing;
  }
  mpm::GridGeometry<2> grid = mpm::grid_around(by_nodes.lower, by_nodes.upper, choice.spacing, margin);
  grid.offset = choice.offset;
  return grid;
}

mpm::GridGeometry<2> grid_of(const Scene& scene) {
  const GridChoice& grid = *scene.grid;
  const Box body = swept_box(scene);
  if (!grid.lower) return grid_around(body, grid, grid_margin);
  for (std::size_t d = 0; d < 2; ++d) {
    if ((*grid.lower)[d] > body.lower[d] || (*grid.upper)[d] < body.upper[d]) {
      refuse(scene, "grid",
             "particles of the body lie outside the grid, whose corners are [" + rounded_text((*grid.lower)[0], 6) +
                 ", " + rounded_text((*grid.lower)[1], 6) + "] and [" + rounded_text((*grid.upper)[0], 6) + ", " +
                 rounded_text((*grid.upper)[1], 6) + "]");
    }
  }
  const int across = mpm::traits_of<2>(scene.method->basis).nodes_across;
  int margin = 1;  // one cell for the domains at the edge, and as many nodes as a particle reaches over
  mpm::GridGeometry<2> found = grid_around({*grid.lower, *grid.upper}, grid, margin);
  while (std::min(found.count[0], found.count[1]) < across) {
    found = grid_around({*grid.lower, *grid.upper}, grid, ++margin);
  }
  return found;
}

/// c = sqrt(E/rho0) of a motion in the unit box that does not say it, and the end of the run that follows from it.
void resolve_wave_speed(Scene& scene) {
  auto* box = scene.motion.as<AxisAligned>();
  if (!box || box->given_speed) return;
  const auto modulus = scene.material.parameters.find("E");
  if (modulus == scene.material.parameters.end() || !(modulus->second > 0)) {
    refuse(scene, "motion.wave_speed",
           "auto takes sqrt(E/rho0), and the material has no parameter E above 0: give it [m/s]");
  }
  const double speed = std::sqrt(modulus->second / scene.material.density);
  if (!(speed >= AxisAligned::least_wave_speed && speed <= AxisAligned::most_wave_speed)) {
    refuse(scene, "motion.wave_speed",
           "auto takes sqrt(E/rho0), which is " + rounded_text(speed, 3) + " m/s, beyond " +
               rounded_text(speed > 1 ? AxisAligned::most_wave_speed : AxisAligned::least_wave_speed, 3) +
               ": give it [m/s]");
  }
  box->amplitude.period = 1 / speed;
  box->given_speed = true;
  if (!scene.places.contains("time.end")) scene.time.end = box->amplitude.period;
}

/// Body force, tractions, and what the body's other faces are.
void choose_forces(Problem& problem) {
  Scene& scene = problem.scene;
  mpm::Setup<2>& setup = problem.setup;
  const bool forced = scene.force.response != ForceChoice::Response::none;
  setup.body_force = forced && scene.motion->accelerates();
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
  setup.ends = ends_of(scene);
  if (setup.has_images() && setup.grid.offset != std::array<double, 2>{}) {
    refuse(scene, "grid.offset",
           "symmetry planes and periodic ends of the body lie on nodes, which an offset takes away from them");
  }
  // a force that is linear in X is on a domain what it is in its middle; at Gauss points their rule takes the mean
  const bool pointwise =
      scene.motion->is_homogeneous() || (!ring_of(scene.motion) && scene.body.lattice == Body::Lattice::gauss);
  setup.evaluation = pointwise ? mpm::Evaluation::point : scene.force.evaluation;
  setup.inertia = scene.force.inertia;
}

/// Far from the origin the numbers themselves may lie further apart than particles can bear.
std::string no_particle_sentence(const Problem& problem) {
  const double spacing = problem.setup.grid.spacing;
  double far = 0;
  for (const auto& corner : {problem.scene.body.lower, problem.scene.body.upper}) {
    for (const double x : corner) far = std::max(far, std::abs(x));
  }
  const double apart = std::nextafter(far, 2 * far) - far;
  std::string sentence = "leaves no particle in the body";
  if (apart < 1e-6 * spacing) return sentence;
  return sentence + ": " + rounded_text(far, 2) + " m from the origin, coordinates are rounded to " +
         rounded_text(apart, 2) + " m; place the body nearer to it";
}

}  // namespace

std::string frame_text(const Frame& frame) {
  const Vector3& c = frame.velocity;
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  if (frame.angle != 0) add("turned by " + rounded_text(frame.angle, 4) + " rad");
  if (frame.spin != 0) add("spin " + rounded_text(frame.spin, 4) + " rad/s");
  if (c != Vector3::Zero()) add("velocity (" + rounded_text(c.x(), 4) + ", " + rounded_text(c.y(), 4) + ") m/s");
  return text.empty() ? "the body's own" : text;
}

std::string Problem::motion_text() const {
  if (is_vortex(scene.motion)) return "; amplitude " + rounded_text(scene.motion->amplitude()->peak, 4);
  std::string text = "; " + motion_type(scene);
  if (setup.traction) {
    text += ", traction by " + in_plain_words(word_of(setup.traction->algorithm)) + ", " +
            word_of(setup.traction->form) + " form";
  }
  return text;
}

std::string Problem::subject() const {
  const mpm::MethodNames names = mpm::names_of(setup.method);
  const mpm::Method& method = setup.method;
  std::string way = names.basis + (method.is_total() ? ", total, " : ", ") + names.transfer + ", " + names.update;
  if (method.mass != mpm::Mass::lumped) way += ", " + names.mass;
  if (method.has_terms()) way += " " + std::to_string(method.terms);
  if (method.integrator != mpm::Integrator::symplectic_euler) way += ", " + word_of(method.integrator);
  for (const auto& effect : mpm::effects<2>()) {
    if (effect.in_title && effect.called_for(setup)) way += ", " + effect.in_title(setup.options);
  }
  return material->name() + "; " + way + "; h = " + rounded_text(scene.grid->spacing, 4) + " m; " +
         std::to_string(scene.body.per_cell[0]) + "x" + std::to_string(scene.body.per_cell[1]) + " a cell" +
         (scene.body.lattice == Body::Lattice::cartesian ? "" : ", " + word_of(scene.body.lattice)) + motion_text() +
         (scene.frame ? "; frame: " + frame_text(*scene.frame) : "") +
         (setup.uses_exact_solution() ? "; uses the exact solution" : "");
}

double Problem::estimated_bytes() const {
  double bytes = static_cast<double>(setup.grid.nodes()) * static_cast<double>(mpm::grid_bytes_per_node(setup));
  for (const auto& use : mpm::columns_of(mpm::compose(setup), setup)) {
    bytes += static_cast<double>(use.bytes) * static_cast<double>(setup.seeds.size());
  }
  const auto stepped = static_cast<double>(setup.seeds.size()), held = static_cast<double>(setup.seeds.held.size());
  constexpr double seed = 2 * sizeof(double), ring_point = 2 * sizeof(double) + sizeof(std::uint32_t);
  bytes += seed * (stepped + held);
  if (compared) bytes += stepped * (2 * ring_point + 4 * sizeof(double));  // force field and error sampler
  if (setup.seeds.domains || setup.evaluation == mpm::Evaluation::domain_average) {
    bytes += stepped * (scene.body.lattice == Body::Lattice::polar ? sector_bytes : cell_bytes);
  }
  if (setup.frame && setup.frame->spin != 0) bytes += stepped * spin_bytes;
  if (setup.uses_exact_solution()) bytes += stepped * inertia_bytes;
  bytes += static_cast<double>(setup.seeds.corners.size() * sizeof(mpm::Corners<2>));
  if (scene.force.response == ForceChoice::Response::shadow) {  // states and stress at both ends of a step, and F
    bytes += scene.force.radii * sizeof(double) * (2.0 * static_cast<double>(material->state_size()) + 4 * 9);
  }
  if (compared && scene.output.pictures) bytes += stepped * 2 * 9 * sizeof(double);  // two frames
  return bytes;
}

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

Problem assemble(const Scene& given, int threads) {
  Problem problem;
  problem.scene = given;
  Scene& scene = problem.scene;
  require_runnable(scene);
  check_sizes(scene);
  problem.material = material_of(scene, problem.library);
  require_reversible(scene, *problem.material);
  require_few_periods(scene, *problem.material);
  mpm::Setup<2>& setup = problem.setup;
  setup.method = *scene.method;
  setup.grid = grid_of(scene);
  setup.seeds = seeds_of(scene);
  mpm::order_by_nodes(setup);
  setup.density = scene.material.density;
  setup.material = problem.material;
  choose_forces(problem);
  setup.motion = scene.motion;
  setup.frame = scene.frame;
  if (const auto& v = scene.body.initial_velocity) setup.initial_velocity = {v->velocity, v->gradient()};
  setup.hold_outside = scene.body.domain != Body::Domain::ring && scene.body.outside == Body::Outside::held;
  setup.accounts = scene.output.accounts;
  setup.options = scene.effects;
  setup.threads = threads;
  if (setup.seeds.size() == 0) refuse(scene, "grid.spacing", no_particle_sentence(problem));
  for (const Path& path : baseline_paths(scene)) setup.material_direction = path.material_direction;
  find_speeds(problem);
  plan_steps(problem);
  check_limits(problem);
  return problem;
}

}  // namespace assay::drivers
