// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/time_steps.hpp"

#include <cmath>
#include <iterator>
#include <string>
#include <utility>

#include "drivers/scene/body_box.hpp"
#include "drivers/scene/scene.hpp"
#include "drivers/simulation/units_hint.hpp"
#include "drivers/text/numbers.hpp"
#include "harness/motion/kinds/vortex3d.hpp"
#include "harness/stability/wave_speed.hpp"

namespace assay::drivers {

namespace {

constexpr double wave_periods = 4;  ///< in which the fastest wave is looked for
constexpr int speed_samples = 400;
constexpr double most_steps = 1e15;   ///< beyond, step times would not be told apart
constexpr double whole_steps = 1e-9;  ///< a number of steps this close to a whole one [relative] is that one

/// Of a box: its corners, or a lattice.
template <int Dim>
std::vector<Vector3> places_in_box(const BoxOf<Dim>& box, int pieces) {
  std::vector<Vector3> places{Vector3::Zero()};
  for (std::size_t d = 0; d < Dim; ++d) {
    std::vector<Vector3> more;
    for (Vector3 place : places) {
      for (int k = 0; k <= pieces; ++k) {
        place[static_cast<int>(d)] = box.lower[d] + (box.upper[d] - box.lower[d]) * k / pieces;
        more.push_back(place);
      }
    }
    places = std::move(more);
  }
  return places;
}

/// Where a motion is looked at to find its fastest point: the corners where F is the same everywhere, radii of a polar
/// motion, a lattice of the box.
std::vector<Vector3> places_of(const Scene& scene) {
  constexpr int radii = 128, across = 16;
  std::vector<Vector3> places;
  if (const auto ring = ring_of(scene.motion)) {
    for (int k = 0; k <= radii; ++k) places.emplace_back(ring->inner + (ring->outer - ring->inner) * k / radii, 0, 0);
    return places;
  }
  const int pieces = scene.motion->is_homogeneous() ? 1 : across;
  return scene.dimension == 3 ? places_in_box(body_box<3>(scene), pieces) : places_in_box(body_box<2>(scene), pieces);
}

/// |v| = R h |g'| is largest where both are (28).
double fastest_of_vortex(const PolarMotion& vortex, double end) {
  const Annulus ring = vortex.ring();
  double profile = 0, rate = 0;
  for (int k = 0; k <= speed_samples; ++k) {
    const double s = static_cast<double>(k) / speed_samples;
    const double R = ring.inner + s * (ring.outer - ring.inner);
    profile = std::max(profile, R * vortex.profile(R).h);
    rate = std::max(rate, std::abs(vortex.turn().at(s * std::min(end, vortex.turn().period)).rate));
  }
  return profile * rate;
}

/// The same of vortices in space, where rho h is largest in a meridian plane.
double fastest_of_vortex(const Vortex3d& motion, double end) {
  constexpr int along_samples = 100;
  double profile = 0, rate = 0;
  for (const Revolution& vortex : motion.all()) {
    const auto [across, along] = vortex.reach();
    for (int i = 0; i <= speed_samples; ++i) {
      for (int k = 0; k <= along_samples; ++k) {
        const double R = across * i / speed_samples;
        if (const auto at = vortex.at(R, along * k / along_samples)) profile = std::max(profile, R * std::abs(at->h));
      }
    }
  }
  for (int k = 0; k <= speed_samples; ++k) {
    const double t = std::min(end, motion.amplitude.period) * k / speed_samples;
    rate = std::max(rate, std::abs(motion.amplitude.at(t).rate));
  }
  return profile * rate;
}

/// A body that is left to itself: at the beginning, at its farthest corner. What it releases is in the fastest wave.
double fastest_of(const InitialVelocity& v, const Box& box) {
  double fastest = 0;
  for (const double x : {box.lower[0], box.upper[0]}) {
    for (const double y : {box.lower[1], box.upper[1]}) {
      const auto corner = v.at(x, y);
      fastest = std::max(fastest, std::hypot(corner[0], corner[1]));
    }
  }
  return fastest;
}

/// The largest of what is asked of the exact motion's states, all over the body until the end; at least 0.
double largest_of_motion(const Scene& scene, const auto& of) {
  double largest = 0;
  for (const Vector3& X : places_of(scene)) {
    for (int k = 0; k <= speed_samples; ++k)
      largest = std::max(largest, of(scene.motion->at(X, scene.time.end * k / speed_samples)));
  }
  return largest;
}

/// What a frame adds to it: its spin at the farthest particle, and its velocity.
template <int Dim>
double fastest_of_frame(const Frame& frame, const mpm::Seeds<Dim>& seeds) {
  double farthest = 0;
  for (std::size_t p = 0; p < seeds.size(); ++p) {
    if constexpr (Dim == 2) farthest = std::max(farthest, std::hypot(seeds.X[0][p], seeds.X[1][p]));
    if constexpr (Dim == 3) farthest = std::max(farthest, std::hypot(seeds.X[0][p], seeds.X[1][p], seeds.X[2][p]));
  }
  return std::abs(frame.spin) * farthest + frame.velocity.norm();
}

/// Equal steps that also meet T/2 where the end is a multiple of it: the error is asked for there.
double steps_by_courant(const PosedScene& problem) {
  const double end = problem.scene.time.end;
  const double longest = problem.scene.method->courant * problem.scene.grid->spacing / fastest_signal(problem);
  const double halves = end / (0.5 * problem.period());
  const bool whole = std::abs(halves - std::round(halves)) < whole_steps * halves;
  const double pieces = whole ? std::round(halves) : 1;
  return pieces * std::max(1.0, std::ceil(end / pieces / longest));
}

}  // namespace

double fastest_of_motion(const Scene& scene) {
  if (scene.body.initial_velocity) return fastest_of(*scene.body.initial_velocity, body_box(scene));
  if (is_vortex(scene.motion)) return fastest_of_vortex(*scene.motion->polar(), scene.time.end);
  if (const auto* vortex = scene.motion.as<Vortex3d>()) return fastest_of_vortex(*vortex, scene.time.end);
  return largest_of_motion(scene, [](const ExactState& state) { return state.v.norm(); });
}

namespace {

/// By which particles are fastest.
const char* key_of_speed(const PosedScene& problem) {
  const double own = fastest_of_motion(problem.scene);
  return problem.scene.frame && problem.particle_speed - own > own ? "frame" : "motion";
}

/// Of all that the number of steps follows from what is farthest from the usual.
std::string key_of_steps(const PosedScene& problem) {
  const Scene& scene = problem.scene;
  if (const auto fixed = scene.time.fixed_step()) return fixed->key;
  constexpr double usual_speed = 1e4, usual_end = 10, usual_spacing = 1e-3, usual_courant = 0.01;  // m/s, s, m
  const std::pair<double, const char*> keys[] = {
      {usual_courant / scene.method->courant, "method.courant"},
      {scene.time.end / usual_end, "time.end"},
      {usual_spacing / scene.grid->spacing, "grid.spacing"},
      {problem.wave_speed / usual_speed, "material.parameters"},
      {problem.particle_speed / usual_speed, key_of_speed(problem)},
  };
  return std::max_element(std::begin(keys), std::end(keys),
                          [](const auto& a, const auto& b) { return a.first < b.first; })
      ->second;
}

}  // namespace

double fastest_shrinking(const Scene& scene) {
  if (const auto& v = scene.body.initial_velocity) return std::max(0.0, -(v->stretching[0] + v->stretching[1]));
  return largest_of_motion(scene, [](const ExactState& state) { return -(state.F_rate * state.F.inverse()).trace(); });
}

double viscous_shortening(const PosedScene& problem, double wave, double shrinking) {
  const auto& viscosity = problem.scene.effects.of<mpm::ArtificialViscosity>();
  if (!viscosity.acts() || !(wave > 0)) return 1;
  const double Q = viscosity.C[0] * problem.wave_speed + viscosity.C[1] * problem.scene.grid->spacing * shrinking;
  return (Q + std::hypot(Q, wave)) / wave;
}

double fastest_signal(const PosedScene& problem) {
  return std::max(problem.viscous_shortening * problem.wave_speed + problem.particle_speed,
                  problem.viscous_shortening * problem.reference_wave_speed);
}

template <int Dim>
void find_speeds(ProblemIn<Dim>& problem) {
  const Scene& scene = problem.scene;
  mpm::Setup<Dim>& setup = problem.setup;
  const double watched = std::min(scene.time.end, wave_periods * problem.period());
  for (const Path& path : baseline_paths(scene)) {
    const auto fastest = [&](WaveFrame in) {
      return fastest_wave_on_path(*problem.material, path, setup.density, watched, in);
    };
    problem.wave_speed = std::max(problem.wave_speed, fastest(WaveFrame::current));
    if (!setup.method.is_total()) continue;
    problem.reference_wave_speed = std::max(problem.reference_wave_speed, fastest(WaveFrame::reference));
  }
  setup.wave_speed = problem.wave_speed;
  if (mpm::option<mpm::ArtificialViscosity>(setup).acts()) {
    problem.viscous_shortening = viscous_shortening(problem, problem.wave_speed, fastest_shrinking(scene));
  }
  const double own = fastest_of_motion(scene);
  problem.particle_speed = scene.frame ? own + fastest_of_frame(*scene.frame, setup.seeds) : own;
}

void plan_steps(PosedScene& problem) {
  const Scene& scene = problem.scene;
  const auto fixed = scene.time.fixed_step();
  if (fixed && fixed->dt > scene.time.end)  // an end that the motion's speed gives is known by now
    refuse(scene, fixed->key, "must not exceed time.end, " + scene.units.text(scene.time.end, "s", 6));
  const double steps = fixed ? std::ceil(scene.time.end / fixed->dt * (1 - whole_steps)) : steps_by_courant(problem);
  if (!(steps >= 1 && steps < most_steps)) {
    const std::string key = key_of_steps(problem), hint = units_hint(problem);
    refuse(scene, key,
           "gives " + rounded_text(steps, 3) + " steps to time.end = " + scene.units.text(scene.time.end, "s", 6) +
               " (fastest wave on the path " + scene.units.text(problem.wave_speed, "m/s", 3) + ", fastest particle " +
               scene.units.text(problem.particle_speed, "m/s", 3) + ")" + (hint.empty() ? "" : ": " + hint));
  }
  if (!std::isfinite(problem.wave_speed + problem.particle_speed)) {  // a step that is given asks for neither
    const char* key = key_of_speed(problem);
    refuse(scene, key,
           "is faster than numbers go: fastest wave on the path " + scene.units.text(problem.wave_speed, "m/s", 3) +
               ", fastest particle " + scene.units.text(problem.particle_speed, "m/s", 3));
  }
  problem.steps = static_cast<std::int64_t>(steps);
  problem.dt = fixed ? fixed->dt : scene.time.end / steps;
}

template void find_speeds(ProblemIn<2>&);
template void find_speeds(ProblemIn<3>&);

}  // namespace assay::drivers
