// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/problem.hpp"

#include <algorithm>
#include <cmath>

#include "drivers/material/material_choice.hpp"
#include "drivers/output/number_format.hpp"
#include "drivers/scene/body_box.hpp"
#include "drivers/scene/scene_keys.hpp"
#include "drivers/simulation/seeds.hpp"
#include "harness/wave_speed.hpp"
#include "mpm/corners.hpp"
#include "mpm/lattice.hpp"
#include "mpm/particle_order.hpp"
#include "mpm/patch/methods.hpp"

namespace assay::drivers {

namespace {

constexpr int grid_margin = 4;  ///< cells around the body: room to go wrong in before the grid's edge
constexpr int speed_samples = 400;
constexpr double wave_periods = 4;                     ///< in which the fastest wave is looked for
constexpr double most_steps = 1e15;                    ///< beyond, step times would not be told apart
constexpr double cell_bytes = 420, sector_bytes = 90;  ///< that averaging over a particle's domain takes (measured)
constexpr double spin_bytes = 120;  ///< that a spinning frame's force takes, its means included (counted)
constexpr double inertia_bytes =
    92;  ///< that giving particles their inertia takes where no two radii are equal (counted)
constexpr double whole_steps = 1e-9;  ///< a number of steps this close to a whole one [relative] is that one

mpm::GridGeometry<2> grid_of(const Scene& scene) {
  const GridChoice& grid = *scene.grid;
  const Box body = swept_box(scene);
  if (!grid.lower) return mpm::grid_around(body.lower, body.upper, grid.spacing, grid_margin);
  for (std::size_t d = 0; d < 2; ++d) {
    if ((*grid.lower)[d] > body.lower[d] || (*grid.upper)[d] < body.upper[d]) {
      throw InputError(scene.place("grid"), "grid",
                       "particles of the body lie outside the grid, whose corners are [" +
                           rounded_text((*grid.lower)[0], 6) + ", " + rounded_text((*grid.lower)[1], 6) + "] and [" +
                           rounded_text((*grid.upper)[0], 6) + ", " + rounded_text((*grid.upper)[1], 6) + "]");
    }
  }
  return mpm::grid_around(*grid.lower, *grid.upper, grid.spacing, 1);  // one cell for the domains at the edge
}

/// Of a motion whose F is the same everywhere some corner is the fastest.
double fastest_corner(const Scene& scene) {
  const Box box = body_box(scene);
  double fastest = 0;
  for (int k = 0; k <= speed_samples; ++k) {
    const double t = scene.time.end * k / speed_samples;
    for (const double X : {box.lower[0], box.upper[0]}) {
      for (const double Y : {box.lower[1], box.upper[1]}) {
        fastest = std::max(fastest, state_at(scene.motion, {X, Y, 0}, t).v.norm());
      }
    }
  }
  return fastest;
}

double fastest_particle(const Scene& scene) {
  if (is_homogeneous(scene.motion)) return fastest_corner(scene);
  const auto& vortex = std::get<Vortex>(scene.motion);
  double profile = 0, rate = 0;
  for (int k = 0; k <= speed_samples; ++k) {
    const double s = static_cast<double>(k) / speed_samples;
    const double R = vortex.inner + s * (vortex.outer - vortex.inner);
    profile = std::max(profile, R * vortex.profile(R).h);
    rate = std::max(rate, std::abs(vortex.amplitude.at(s * std::min(scene.time.end, vortex.amplitude.period)).rate));
  }
  return profile * rate;  // (28)
}

/// What a frame adds to it: its spin at the farthest particle, and its velocity.
double fastest_of_frame(const Frame& frame, const mpm::Seeds<2>& seeds) {
  double farthest = 0;
  for (std::size_t p = 0; p < seeds.size(); ++p)
    farthest = std::max(farthest, std::hypot(seeds.X[0][p], seeds.X[1][p]));
  return std::abs(frame.spin) * farthest + frame.velocity.norm();
}

/// Equal steps that also meet T/2 where the end is a multiple of it: the error is asked for there.
double steps_by_courant(const Problem& problem) {
  const double end = problem.scene.time.end;
  const double speed = problem.wave_speed + problem.particle_speed;
  const double longest = problem.scene.method->courant * problem.scene.grid->spacing / speed;
  const double halves = end / (0.5 * problem.period());
  const bool whole = std::abs(halves - std::round(halves)) < whole_steps * halves;
  const double pieces = whole ? std::round(halves) : 1;
  return pieces * std::max(1.0, std::ceil(end / pieces / longest));
}

void plan_steps(Problem& problem) {
  const Scene& scene = problem.scene;
  const std::string key = scene.time.step ? "time.step" : "method.courant";
  const double steps =
      scene.time.step ? std::ceil(scene.time.end / *scene.time.step * (1 - whole_steps)) : steps_by_courant(problem);
  if (!(steps >= 1 && steps < most_steps)) {
    throw InputError(scene.place(key), key,
                     "gives " + rounded_text(steps, 3) + " steps to time.end = " + rounded_text(scene.time.end, 6) +
                         " s (fastest wave on the path " + rounded_text(problem.wave_speed, 3) +
                         " m/s, fastest particle " + rounded_text(problem.particle_speed, 3) + " m/s)");
  }
  problem.steps = static_cast<std::int64_t>(steps);
  problem.dt = scene.time.step ? *scene.time.step : scene.time.end / steps;
}

bool takes_shadow(const Scene& scene) { return scene.force.response == ForceChoice::Response::shadow; }

void check_limits(const Problem& problem) {
  const Scene& scene = problem.scene;
  const double gib = problem.estimated_bytes() / (1024.0 * 1024 * 1024);
  if (gib > scene.limits.memory_gib) {
    throw InputError(scene.place("limits.memory_gib"), "limits.memory_gib",
                     "the run would need " + rounded_text(gib, 3) + " GiB, the limit is " +
                         rounded_text(scene.limits.memory_gib, 6));
  }
  const double histories = takes_shadow(scene) ? scene.force.radii : 0;
  const double particle_steps =
      static_cast<double>(problem.steps) * (static_cast<double>(problem.setup.seeds.size()) + histories);
  if (particle_steps > scene.limits.particle_steps) {
    throw InputError(scene.place("limits.particle_steps"), "limits.particle_steps",
                     "the run would take " + rounded_text(particle_steps, 3) + " particle-steps, the limit is " +
                         rounded_text(scene.limits.particle_steps, 6));
  }
}

/// Before a lattice and a grid are made: whether their sizes alone are out of all bounds.
void check_sizes(const Scene& scene) {
  constexpr double most = 2e9;  // particles and nodes are counted in 32 bits
  const GridChoice& grid = *scene.grid;
  const Box body = body_box(scene), swept = swept_box(scene);
  double particles = 1, nodes = 1;
  for (std::size_t d = 0; d < 2; ++d) {
    particles *= (body.upper[d] - body.lower[d]) / grid.spacing * scene.body.per_cell[d];
    const double width = grid.lower ? (*grid.upper)[d] - (*grid.lower)[d] : swept.upper[d] - swept.lower[d];
    nodes *= width / grid.spacing + 2 * grid_margin + 2;
  }
  const auto check = [&](double count, double bytes_each, const std::string& key, const std::string& what) {
    const double gib = count * bytes_each / (1024.0 * 1024 * 1024);
    if (gib <= scene.limits.memory_gib && count < most) return;
    throw InputError(scene.place(key), key,
                     "makes about " + rounded_text(count, 3) + " " + what +
                         ": more than limits.memory_gib = " + rounded_text(scene.limits.memory_gib, 6) + " can hold");
  };
  check(particles, 2 * sizeof(double), "grid.spacing", "particles");
  check(nodes, 9 * sizeof(double), grid.lower ? "grid.upper" : "grid.spacing", "grid nodes");
}

/// Edges of domains lie on a box whose corners are corners of these.
void require_surface(const Scene& scene) {
  for (std::size_t d = 0; d < 2; ++d) {
    const double particle = scene.grid->spacing / scene.body.per_cell[d];
    for (const double corner : {scene.body.lower[d], scene.body.upper[d]}) {
      if (std::abs(corner / particle - std::round(corner / particle)) <= whole_steps * std::abs(corner / particle))
        continue;
      throw InputError(scene.place("body"), "body",
                       "tractions act on the edges of the particles' domains: the corners must be multiples of "
                       "grid.spacing / body.per_cell = " +
                           rounded_text(particle, 6));
    }
  }
}

void require_runnable(const Scene& scene) {
  const auto* vortex = std::get_if<Vortex>(&scene.motion);
  if (!vortex && !is_homogeneous(scene.motion)) {
    throw InputError(scene.place("motion.type"), "motion.type",
                     "this motion serves tabulate and eval, and cannot be run yet",
                     "vortex, homogeneous, rotating_stretch, rigid");
  }
  if (!is_plane(scene.motion)) {
    throw InputError(scene.place("motion"), "motion",
                     "the method is plane strain: nothing may happen out of the plane, and axes must be [0, 0, 1]");
  }
  if (vortex && vortex->amplitude.type == Amplitude::Type::ramp && scene.time.end > vortex->amplitude.period) {
    throw InputError(scene.place("time.end"), "time.end",
                     "a ramp stops dead at its period: the velocity jumps there, which no body force can do");
  }
  if (!scene.method)
    throw InputError(scene.place("method"), "method",
                     "a scene without a method cannot be run: only tabulated, evaluated and checked");
  if (!scene.grid) throw InputError(scene.place("grid"), "grid", "required to run");
  if (!vortex) require_surface(scene);
}

/// Of the two forms of a traction the one that keeps the exact motion stable: P N dA0 where the body is stretched,
/// sigma n ds where it is compressed, on the mean of both principal directions when it is most deformed.
/// Virtual stress holds as sigma in both.
mpm::TractionForm stable_form(const Scene& scene) {
  constexpr int looks = 200;
  if (scene.traction.algorithm == mpm::TractionAlgorithm::virtual_stress) return mpm::TractionForm::follower;
  double most = 0;
  for (int k = 1; k <= looks; ++k) {
    const Tensor F = state_at(scene.motion, Vector3::Zero(), scene.time.end * k / looks).F;
    const double square = F.topLeftCorner<2, 2>().squaredNorm(), J = F.topLeftCorner<2, 2>().determinant();
    const double stretch = 0.5 * std::sqrt(square + 2 * J) - 1;  // (lambda1 + lambda2)/2 - 1
    if (std::abs(stretch) > std::abs(most)) most = stretch;
  }
  return most >= 0 ? mpm::TractionForm::reference : mpm::TractionForm::follower;
}

/// On all faces of a body that the motion deforms.
std::optional<mpm::Traction> traction_of(Scene& scene) {
  const bool deformed = std::holds_alternative<Homogeneous>(scene.motion) ||
                        std::holds_alternative<DeformationTable>(scene.motion) ||
                        std::holds_alternative<RotatingStretch>(scene.motion);
  if (!deformed || scene.force.response == ForceChoice::Response::none) return std::nullopt;
  if (!scene.traction.form) scene.traction.form = stable_form(scene);
  return mpm::Traction{scene.traction.algorithm, *scene.traction.form};
}

/// Stages of a step go back in time, which only a stress that follows from F alone can do with them.
void require_reversible(const Scene& scene, const Material& material) {
  if (!scene.method->has_stages() || material.is_function_of_F()) return;
  throw InputError(scene.place("method.integrator"), "method.integrator",
                   "symplectic_rkn4 goes back in time within a step, and the stress of '" + material.name() +
                       "' is not a function of F alone: it has a history or a rate",
                   "symplectic_euler, leapfrog");
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
  if (const auto* vortex = std::get_if<Vortex>(&scene.motion)) {
    return "; amplitude " + rounded_text(vortex->amplitude.peak, 4);
  }
  std::string text = "; " + motion_type(scene);
  constexpr const char* algorithms[] = {"edges", "virtual stress", "particles", "undeformed edges"};
  constexpr const char* forms[] = {"follower", "reference"};
  if (setup.traction) {
    text += ", traction by " + std::string(algorithms[static_cast<int>(setup.traction->algorithm)]) + ", " +
            forms[static_cast<int>(setup.traction->form)] + " form";
  }
  return text;
}

std::string Problem::subject() const {
  const mpm::MethodNames names = mpm::names_of(setup.method);
  const mpm::Method& method = setup.method;
  constexpr const char* integrators[] = {"", ", leapfrog", ", symplectic_rkn4"};
  constexpr const char* lattices[] = {"", ", polar", ", gauss", ", jittered"};
  std::string way = names.basis + (method.is_total() ? ", total, " : ", ") + names.transfer + ", " + names.update;
  if (method.mass != mpm::Mass::lumped) way += ", " + names.mass;
  if (method.has_terms()) way += " " + std::to_string(method.terms);
  way += integrators[static_cast<int>(method.integrator)];
  return material->name() + "; " + way + "; h = " + rounded_text(scene.grid->spacing, 4) + " m; " +
         std::to_string(scene.body.per_cell[0]) + "x" + std::to_string(scene.body.per_cell[1]) + " a cell" +
         lattices[static_cast<int>(scene.body.lattice)] + motion_text() +
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
  if (takes_shadow(scene)) {  // states and stress at both ends of a step, and F
    bytes += scene.force.radii * sizeof(double) * (2.0 * static_cast<double>(material->state_size()) + 4 * 9);
  }
  if (compared && scene.output.pictures) bytes += stepped * 2 * 9 * sizeof(double);  // two frames
  return bytes;
}

namespace {

/// c = sqrt(E/rho0) of a motion in the unit box that does not say it, and the end of the run that follows from it.
void resolve_wave_speed(Scene& scene) {
  auto* box = std::get_if<AxisAligned>(&scene.motion);
  if (!box || box->given_speed) return;
  const auto modulus = scene.material.parameters.find("E");
  if (modulus == scene.material.parameters.end() || !(modulus->second > 0)) {
    throw InputError(scene.place("motion.wave_speed"), "motion.wave_speed",
                     "auto takes sqrt(E/rho0), and the material has no parameter E above 0: give it [m/s]");
  }
  box->amplitude.period = 1 / std::sqrt(modulus->second / scene.material.density);
  box->given_speed = true;
  if (!scene.places.contains("time.end")) scene.time.end = box->amplitude.period;
}

}  // namespace

std::shared_ptr<const Material> material_of(Scene& scene, std::string& library) {
  ResolvedMaterial resolved = resolve_material(scene);
  scene.material = std::move(resolved.choice);
  library = std::move(resolved.library);
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
  const double density = scene.material.density;
  mpm::Setup<2>& setup = problem.setup;
  setup.method = *scene.method;
  setup.grid = grid_of(scene);
  setup.seeds = seeds_of(scene);
  mpm::order_by_nodes(setup);
  setup.density = density;
  setup.material = problem.material;
  const bool forced = scene.force.response != ForceChoice::Response::none;
  setup.body_force = forced && accelerates(scene.motion);
  problem.compared = forced;
  setup.traction = traction_of(scene);
  if (!setup.traction) setup.seeds.surface.clear();
  // a force that is linear in X is on a domain what it is in its middle
  setup.evaluation = is_homogeneous(scene.motion) ? mpm::Evaluation::point : scene.force.evaluation;
  setup.inertia = scene.force.inertia;
  setup.motion = scene.motion;
  setup.frame = scene.frame;
  setup.hold_outside = scene.body.domain != Body::Domain::ring && scene.body.outside == Body::Outside::held;
  setup.accounts = scene.output.accounts;
  setup.threads = threads;
  if (setup.seeds.size() == 0)
    throw InputError(scene.place("grid.spacing"), "grid.spacing", "leaves no particle in the body");
  const Path path = baseline_path(scene);
  setup.material_direction = path.material_direction;
  const double watched = std::min(scene.time.end, wave_periods * problem.period());
  problem.wave_speed = fastest_wave_on_path(*problem.material, path, density, watched);
  problem.particle_speed = fastest_particle(scene);
  if (scene.frame) problem.particle_speed += fastest_of_frame(*scene.frame, setup.seeds);
  plan_steps(problem);
  check_limits(problem);
  return problem;
}

}  // namespace assay::drivers
