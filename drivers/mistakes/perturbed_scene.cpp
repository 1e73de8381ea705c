// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/mistakes/perturbed_scene.hpp"

#include <algorithm>
#include <cmath>

#include "drivers/simulation/response_source.hpp"
#include "harness/exact/places.hpp"
#include "harness/stability/wave_speed.hpp"

namespace assay::drivers {

namespace {

constexpr int across_ring = 48, across_box = 16;  ///< elements
constexpr double later = 1.25;                    ///< clocks of loads may be so much faster

/// Which parts b has, looked at in a few instants.
void find_parts_of_force(PerturbedProblem& problem, const std::vector<Vector3>& X, double end) {
  double of_stress = 0, of_motion = 0, speed = 0;
  for (const double t : {0.11 * end, 0.42 * end, 0.73 * end}) {
    for (const Vector3& place : X) {
      const ExactPoint point = problem.exact->at(place, t);
      of_stress = std::max(of_stress, point.stress.static_force.norm());
      of_motion = std::max(of_motion, point.state.a.norm());
      speed = std::max(speed, point.state.v.norm());
    }
  }
  constexpr double nothing = 1e-6;
  problem.has_acceleration = of_motion > nothing * speed / end;
  problem.has_static_force = of_stress > nothing * std::max(of_motion, speed / end);
}

/// A few points of the body.
std::vector<Vector3> points_of(const Scene& scene) {
  std::vector<Vector3> X;
  const auto ring = ring_of(scene.motion);
  for (const double p : {0.21, 0.43, 0.68, 0.87}) {
    if (ring) {
      X.emplace_back(ring->inner + p * (ring->outer - ring->inner), 0, 0);
      continue;
    }
    for (const double q : {0.17, 0.46, 0.81}) {
      X.emplace_back(scene.body.lower[0] + p * (scene.body.upper[0] - scene.body.lower[0]),
                     scene.body.lower[1] + q * (scene.body.upper[1] - scene.body.lower[1]), 0);
    }
  }
  return X;
}

std::unique_ptr<PerturbedBody> body_of(const Scene& scene, RingSupport support, int elements) {
  if (!scene.motion->polar()) return perturbed_box(scene.motion, scene.body.lower, scene.body.upper, elements);
  const double half = 0.25 * (scene.body.upper[0] - scene.body.lower[0] + scene.body.upper[1] - scene.body.lower[1]);
  const double of_same_area = half * std::sqrt(4 / M_PI);
  return perturbed_ring(scene.motion, support, elements, of_same_area);
}

/// As between the rows of a table. Loads that jump are taken wrongly by steps of any code.
bool acceleration_jumps(const Motion& motion) {
  constexpr int instants = 20000;
  constexpr double jump = 0.02;  // of the largest; what is smooth changes by 1e-3
  const Vector3 X(0.83, 0.61, 0);
  double largest = 0, change = 0;
  Vector3 before = motion->at(X, 0).a;
  for (int k = 1; k <= instants; ++k) {
    const Vector3 a = motion->at(X, motion->period() * k / instants).a;
    change = std::max(change, (a - before).norm()), largest = std::max(largest, a.norm());
    before = a;
  }
  return change > jump * largest;
}

}  // namespace

std::string why_no_mistakes(const Scene& scene) {
  if (scene.dimension == 3 || !scene.motion->is_plane()) return "in space";
  if (scene.frame) return "in a moving frame";
  if (scene.force.quasi_static) return "without inertia";
  if (!scene.initial_cauchy().isZero(0)) return "under an initial stress";
  if (acceleration_jumps(scene.motion))
    return "in a motion whose acceleration jumps: steps of time may miss that. `interpolation: spline` is smooth";
  return {};
}

BinnedErrors bins_of(const Scene& scene) { return {scene.motion, scene.body.lower, scene.body.upper}; }

PerturbedProblem perturbed_problem(const Scene& scene, const std::shared_ptr<const Material>& material, double end) {
  PerturbedProblem problem;
  problem.material = material;
  problem.density = scene.material.density;
  problem.known = later * end;
  problem.exact = exact_solution_of_points(scene, material, problem.known);
  for (const Path& path : baseline_paths(scene)) {
    problem.direction = Eigen::Map<const Vector3>(path.material_direction.data());
    problem.wave_speed =
        std::max({problem.wave_speed, fastest_wave_on_path(*material, path, problem.density, end, WaveFrame::current),
                  fastest_wave_on_path(*material, path, problem.density, end, WaveFrame::reference)});
  }
  const std::vector<Vector3> X = points_of(scene);
  find_parts_of_force(problem, X, end);
  problem.moves_at_first =
      std::ranges::any_of(X, [&](const Vector3& place) { return problem.exact->state(place, 0).v.norm() > 0; });
  return problem;
}

PerturbedMotions perturbed_motions(const Scene& scene, const PerturbedProblem& problem, const BinnedErrors& errors,
                                   const std::vector<double>& times) {
  PerturbedMotions motions;
  const auto add = [&](RingSupport support) {
    const int elements = scene.motion->polar() ? across_ring : across_box;
    const auto mesh = [&](int count) {
      return std::make_unique<const PerturbedMotion>(problem, body_of(scene, support, count), times);
    };
    motions.push_back({mesh(elements / 2), mesh(elements)});
  };
  if (!is_vortex(scene.motion)) {
    add(RingSupport::free);
  } else if (errors.any_outside) {
    add(errors.rests_outside ? RingSupport::held : RingSupport::free_outside);
  } else {
    add(RingSupport::free), add(RingSupport::held);
  }
  return motions;
}

double error_of_grid(const Scene& scene, const PerturbedProblem& problem, const BinnedErrors& errors, double h) {
  const auto ring = ring_of(scene.motion);
  const double width =
      ring ? ring->outer - ring->inner
           : std::max(scene.body.upper[0] - scene.body.lower[0], scene.body.upper[1] - scene.body.lower[1]);
  const int most = 2 * (ring ? across_ring : across_box);
  const double of_code = std::max(2.0, std::round(width / h));
  const int elements = std::min(most, static_cast<int>(std::min(of_code, 1e6)));
  const RingSupport support = errors.any_outside && errors.rests_outside ? RingSupport::held : RingSupport::free;
  const PerturbedMotion motion(problem, body_of(scene, support, elements), errors.t);
  const PerturbedHistory right = motion.run(Mistake());
  double sum = 0, count = 0;
  for (std::size_t k = 0; k < right.x.size(); ++k) {
    for (std::size_t i = 0; i < right.x[k].size(); ++i) {
      const Vector3 x = problem.exact->state(motion.body().nodes[i], errors.t[k]).x;
      sum += (right.x[k][i] - x).squaredNorm(), ++count;
    }
  }
  const double finer = elements / of_code;  // the error falls with its square
  return count > 0 ? finer * finer * std::sqrt(sum / count) : 0;
}

}  // namespace assay::drivers
