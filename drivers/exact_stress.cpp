// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/exact_stress.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "drivers/interrupt.hpp"
#include "drivers/output/number_format.hpp"
#include "drivers/simulation/problem.hpp"
#include "drivers/simulation/response_source.hpp"
#include "harness/axis_aligned_force.hpp"
#include "harness/body_force.hpp"
#include "harness/point_driver.hpp"

namespace assay::drivers {

namespace {

constexpr double most_periods = 1000;   ///< of one history
constexpr double edge_rounding = 1e-9;  ///< of a radius: points on the ring's edges are in the ring

/// Stress and body force of the vortex (20), (31).
ExactStress stress_of(const Vortex& vortex, const Response& response, double density, const Vector3& X, double t,
                      const Tensor& F) {
  const double R = std::hypot(X.x(), X.y());
  Tensor tau, dtau_dxi;
  response.at(vortex.profile(R).xi, t, tau, dtau_dxi);
  ExactStress stress;
  stress.first_piola_kirchhoff = rotated_to(vortex, X, t, tau);
  stress.cauchy = cauchy_stress(stress.first_piola_kirchhoff, F);
  const Polar b = body_force(vortex, density, R, t, tau, dtau_dxi);
  const double theta = std::atan2(X.y(), X.x()) + vortex.amplitude.at(t).value * vortex.profile(R).h;
  stress.body_force = rotation_about_z(theta) * Vector3(b.r, b.theta, 0);  // (31), (25)
  return stress;
}

/// Stress and body force of a twisting ring.
ExactStress stress_of(const TwistingRing& ring, const Response& response, double density, const Vector3& X, double t,
                      const Tensor& F) {
  const double R = std::clamp(std::hypot(X.x(), X.y()), ring.inner(), ring.outer());
  const RingKinematics now = ring.ring(R, t);
  Tensor tau, dtau_dR;
  response.at(R, t, tau, dtau_dR);
  ExactStress stress;
  stress.first_piola_kirchhoff = now.first_piola_kirchhoff(X, tau);
  stress.cauchy = cauchy_stress(stress.first_piola_kirchhoff, F);
  stress.body_force = now.cartesian(X, now.body_force(density, R, tau, dtau_dR));
  return stress;
}

ExactPoint seen_from(const Frame& frame, const ExactPoint& point, double t) {
  return {frame.seen(point.state, t), frame.seen(point.stress, point.state, t)};
}

/// tau of one history at the times of the points [Pa].
std::vector<Tensor> own_history(const Scene& scene, const Material& material, double own,
                                const std::vector<ReferencePoint>& points) {
  std::vector<double> times;
  for (const ReferencePoint& point : points) times.push_back(point.t);
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  if (!times.empty() && times.back() == 0) return std::vector<Tensor>(points.size(), Tensor::Zero());
  const Path path = baseline_path(scene);
  const Histories history = integrate_histories(material, path, std::array{own}, times, {.tolerance = 1e-13});
  std::vector<Tensor> tau(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto k = std::lower_bound(times.begin(), times.end(), points[i].t) - times.begin();
    for (int c = 0; c < 9; ++c) {
      component(tau[i], c) = history.tau[static_cast<std::size_t>(k)][static_cast<std::size_t>(c)];
    }
  }
  return tau;
}

/// tau at the points of a homogeneous motion [Pa].
std::vector<Tensor> homogeneous_tau(const Scene& scene, const std::shared_ptr<const Material>& material,
                                    const std::vector<ReferencePoint>& points, double end) {
  const double own = own_parameter(scene.motion);
  const Path path = baseline_path(scene);
  const bool form = scene.force.response == ForceChoice::Response::closed_form;
  if (!form && !(path.straight() && material->path_independent())) {
    if (end > most_periods * period_of(scene.motion)) {
      throw InputError(scene.place("time.end"), "time.end",
                       "a history holds at most " + rounded_text(most_periods, 6) + " periods");
    }
    return own_history(scene, *material, own, points);
  }
  const auto response = response_of(scene, material, path, end);
  std::vector<Tensor> tau(points.size());
  Tensor slope;
  for (std::size_t i = 0; i < points.size(); ++i) response->at(own, points[i].t, tau[i], slope);
  return tau;
}

/// The stress of points at rest is that of t = 0, where nothing is deformed.
void add_box_stress(const Scene& scene, const AxisAligned& motion, const Material& material,
                    const std::vector<ReferencePoint>& points, const std::vector<Vector3>& X,
                    std::vector<ExactPoint>& out) {
  const std::array<double, 3> direction = baseline_path(scene).material_direction;
  std::map<std::array<double, 2>, std::map<double, std::vector<std::size_t>>> by_place;  // then by time
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].t > 0) by_place[{X[i].x(), X[i].y()}][points[i].t].push_back(i);
  }
  for (const auto& [place, by_time] : by_place) {
    stop_if_interrupted();
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
template <class Ring>
void add_ring_stress(const Scene& scene, const Ring& ring, const std::shared_ptr<const Material>& material,
                     const std::vector<ReferencePoint>& points, const std::vector<Vector3>& X, double end,
                     std::vector<ExactPoint>& out) {
  const auto response = response_of(scene, material, baseline_path(scene), end);
  for (std::size_t i = 0; i < points.size(); ++i) {
    stop_if_interrupted();
    out[i].stress = stress_of(ring, *response, scene.material.density, X[i], points[i].t, out[i].state.F);
  }
}

/// P = tau, b = a where F is the same everywhere.
void add_stress(const Scene& scene, const std::shared_ptr<const Material>& material,
                const std::vector<ReferencePoint>& points, const std::vector<Vector3>& X, double end,
                std::vector<ExactPoint>& out) {
  if (const auto* vortex = std::get_if<Vortex>(&scene.motion)) {
    add_ring_stress(scene, *vortex, material, points, X, end, out);
  } else if (const auto* ring = std::get_if<TwistingRing>(&scene.motion)) {
    add_ring_stress(scene, *ring, material, points, X, end, out);
  } else if (const auto* box = std::get_if<AxisAligned>(&scene.motion)) {
    add_box_stress(scene, *box, *material, points, X, out);
  } else {
    const std::vector<Tensor> tau = homogeneous_tau(scene, material, points, end);
    for (std::size_t i = 0; i < out.size(); ++i) {
      out[i].stress = {tau[i], cauchy_stress(tau[i], out[i].state.F), out[i].state.a};
    }
  }
}

}  // namespace

void require_within_motion(const Scene& scene, const std::vector<ReferencePoint>& points, const std::string& file) {
  if (const auto* ring = std::get_if<TwistingRing>(&scene.motion)) {
    for (const ReferencePoint& point : points) {
      const double R = std::hypot(point.X, point.Y);
      if (R >= ring->inner() * (1 - edge_rounding) && R <= ring->outer() * (1 + edge_rounding)) continue;
      throw InputError({file, point.line, 1}, "X",
                       "the point is at the radius " + rounded_text(R, 6) + ", outside of the ring between " +
                           rounded_text(ring->inner(), 6) + " and " + rounded_text(ring->outer(), 6));
    }
  }
  const auto* table = std::get_if<DeformationTable>(&scene.motion);
  for (const ReferencePoint& point : points) {
    if (!table || point.t <= table->last()) continue;
    throw InputError({file, point.line, 1}, "t",
                     "beyond the last row of motion.path, " + rounded_text(table->last(), 6));
  }
}

std::vector<ExactPoint> exact_points(const Scene& scene, const std::shared_ptr<const Material>& material,
                                     const std::vector<ReferencePoint>& points, double end) {
  std::vector<Vector3> X;
  std::vector<ExactPoint> out;
  for (const ReferencePoint& point : points) {
    X.emplace_back(point.X, point.Y, point.Z);
    if (scene.frame) X.back() = scene.frame->body_point(X.back());
    out.push_back({state_at(scene.motion, X.back(), point.t), {}});
  }
  add_stress(scene, material, points, X, end, out);
  for (std::size_t i = 0; scene.frame && i < out.size(); ++i) out[i] = seen_from(*scene.frame, out[i], points[i].t);
  return out;
}

}  // namespace assay::drivers
