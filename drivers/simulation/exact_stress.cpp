// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/exact_stress.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "drivers/simulation/problem.hpp"
#include "drivers/simulation/response_source.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/system/progress.hpp"
#include "drivers/text/number_format.hpp"
#include "harness/exact/axis_aligned_force.hpp"
#include "harness/motion/kinds/axis_aligned.hpp"
#include "harness/motion/kinds/deformation_table.hpp"

namespace assay::drivers {

namespace {

constexpr double most_history_periods = 1000;  ///< of one history
constexpr double history_tolerance = 1e-13;    ///< of a step
constexpr double radius_rounding = 1e-9;       ///< of a radius: points on the ring's edges are in the ring

ExactPoint seen_from(const Frame& frame, const ExactPoint& point, double t) {
  return {frame.seen(point.state, t), frame.seen(point.stress, point.state, t)};
}

/// P at the points of a motion whose F is the same everywhere [Pa].
std::vector<Tensor> homogeneous_tau(const Scene& scene, const std::shared_ptr<const Material>& material,
                                    const std::vector<ReferencePoint>& points, double end) {
  const double own = own_parameter(scene.motion);
  const Path path = baseline_path(scene);
  std::vector<Tensor> tau(points.size(), Tensor::Zero());
  if (scene.force.response == ForceChoice::Response::closed_form) {
    const auto response = response_of(scene, material, path, end);
    Tensor slope;
    for (std::size_t i = 0; i < points.size(); ++i) response->at(own, points[i].t, tau[i], slope);
    return tau;
  }
  HomogeneousStress stress(material, path, own, end, history_tolerance);
  if (stress.is_history() && end > most_history_periods * period_of(scene.motion)) {
    throw InputError(scene.place("time.end"), "time.end",
                     "a history holds at most " + rounded_text(most_history_periods, 6) + " periods");
  }
  std::map<double, std::vector<std::size_t>> by_time;
  for (std::size_t i = 0; i < points.size(); ++i) by_time[points[i].t].push_back(i);
  for (const auto& [t, which] : by_time) {
    stop_if_interrupted();
    for (const std::size_t i : which) tau[i] = stress.at(t);
  }
  return tau;
}

/// The stress of points at rest is that of t = 0, where nothing is deformed.
void add_box_stress(const Scene& scene, const AxisAligned& motion, const Material& material,
                    const std::vector<ReferencePoint>& points, const std::vector<Vector3>& X, Progress& progress,
                    std::vector<ExactPoint>& out) {
  const std::array<double, 3> direction = baseline_path(scene).material_direction;
  std::map<std::array<double, 2>, std::map<double, std::vector<std::size_t>>> by_place;  // then by time
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].t > 0) by_place[{X[i].x(), X[i].y()}][points[i].t].push_back(i);
  }
  double places = 0;
  for (const auto& [place, by_time] : by_place) {
    stop_if_interrupted();
    progress.update(places++ / static_cast<double>(by_place.size()), "histories");
    std::vector<double> times;
    for (const auto& [t, which] : by_time) times.push_back(t);
    const auto stress =
        axis_aligned_stress(material, motion, scene.material.density, {place[0], place[1], 0}, times, direction);
    std::size_t k = 0;
    for (const auto& [t, which] : by_time) {
      for (const std::size_t i : which) out[i].stress = stress[k];
      ++k;
    }
  }
}

/// Of a polar motion, by tau of the response that the scene asks for (20).
void add_ring_stress(const Scene& scene, const std::shared_ptr<const Material>& material,
                     const std::vector<ReferencePoint>& points, const std::vector<Vector3>& X, double end, bool quiet,
                     std::vector<ExactPoint>& out) {
  const ExactSolution solution(scene.motion, scene.material.density,
                               response_of(scene, material, baseline_path(scene), end, {.quiet = quiet}));
  Progress progress("eval", quiet);
  for (std::size_t i = 0; i < points.size(); ++i) {
    stop_if_interrupted();
    progress.update(static_cast<double>(i) / static_cast<double>(points.size()), "points");
    out[i].stress = solution.stress(X[i], points[i].t);
  }
}

/// P = tau, b = a where F is the same everywhere.
void add_stress(const Scene& scene, const std::shared_ptr<const Material>& material,
                const std::vector<ReferencePoint>& points, const std::vector<Vector3>& X, double end, bool quiet,
                std::vector<ExactPoint>& out) {
  if (ring_of(scene.motion)) {
    add_ring_stress(scene, material, points, X, end, quiet, out);
  } else if (const auto* box = scene.motion.as<AxisAligned>()) {
    Progress progress("eval", quiet);
    add_box_stress(scene, *box, *material, points, X, progress, out);
  } else {
    const std::vector<Tensor> tau = homogeneous_tau(scene, material, points, end);
    for (std::size_t i = 0; i < out.size(); ++i) {
      out[i].stress = {tau[i], cauchy_stress(tau[i], out[i].state.F), out[i].state.a};
    }
  }
}

}  // namespace

void require_within_motion(const Scene& scene, const std::vector<ReferencePoint>& points, const std::string& file) {
  if (const auto ring = ring_of(scene.motion); ring && !is_vortex(scene.motion)) {
    for (const ReferencePoint& point : points) {
      const double R = std::hypot(point.X, point.Y);
      if (R >= ring->inner * (1 - radius_rounding) && R <= ring->outer * (1 + radius_rounding)) continue;
      throw InputError({file, point.line, 1}, "X",
                       "the point is at the radius " + rounded_text(R, 6) + ", outside of the ring between " +
                           rounded_text(ring->inner, 6) + " and " + rounded_text(ring->outer, 6));
    }
  }
  const auto* table = scene.motion.as<DeformationTable>();
  for (const ReferencePoint& point : points) {
    if (!table || point.t <= table->last()) continue;
    throw InputError({file, point.line, 1}, "t",
                     "beyond the last row of motion.path, " + rounded_text(table->last(), 6));
  }
}

std::vector<ExactPoint> exact_points(const Scene& scene, const std::shared_ptr<const Material>& material,
                                     const std::vector<ReferencePoint>& points, double end, bool quiet) {
  std::vector<Vector3> X;
  std::vector<ExactPoint> out;
  for (const ReferencePoint& point : points) {
    X.emplace_back(point.X, point.Y, point.Z);
    if (scene.frame) X.back() = scene.frame->body_point(X.back());
    out.push_back({state_at(scene.motion, X.back(), point.t), {}});
  }
  add_stress(scene, material, points, X, end, quiet, out);
  for (std::size_t i = 0; scene.frame && i < out.size(); ++i) out[i] = seen_from(*scene.frame, out[i], points[i].t);
  return out;
}

}  // namespace assay::drivers
