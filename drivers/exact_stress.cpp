// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/exact_stress.hpp"

#include <algorithm>
#include <cmath>

#include "drivers/interrupt.hpp"
#include "drivers/output/number_format.hpp"
#include "drivers/simulation/problem.hpp"
#include "drivers/simulation/response_source.hpp"
#include "harness/body_force.hpp"
#include "harness/point_driver.hpp"

namespace assay::drivers {

namespace {

constexpr double most_periods = 1000;  ///< of one history

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

double own_parameter_of(const Motion& motion) {
  if (const auto* straight = std::get_if<Homogeneous>(&motion)) return straight->own_parameter();
  return 1;
}

/// tau at the points of a homogeneous motion [Pa].
std::vector<Tensor> homogeneous_tau(const Scene& scene, const std::shared_ptr<const Material>& material,
                                    const std::vector<ReferencePoint>& points, double end) {
  const double own = own_parameter_of(scene.motion);
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

}  // namespace

void require_within_path(const Scene& scene, const std::vector<ReferencePoint>& points, const std::string& file) {
  const auto* table = std::get_if<DeformationTable>(&scene.motion);
  for (const ReferencePoint& point : points) {
    if (!table || point.t <= table->last()) continue;
    throw InputError({file, point.line, 1}, "t",
                     "beyond the last row of motion.path, " + rounded_text(table->last(), 6));
  }
}

std::vector<ExactPoint> exact_points(const Scene& scene, const std::shared_ptr<const Material>& material,
                                     const std::vector<ReferencePoint>& points, double end) {
  const auto* vortex = std::get_if<Vortex>(&scene.motion);
  std::vector<Tensor> tau;
  std::shared_ptr<const Response> response;
  if (vortex)
    response = response_of(scene, material, baseline_path(scene), end);
  else
    tau = homogeneous_tau(scene, material, points, end);
  std::vector<ExactPoint> out;
  for (std::size_t i = 0; i < points.size(); ++i) {
    stop_if_interrupted();
    const double t = points[i].t;
    Vector3 X(points[i].X, points[i].Y, points[i].Z);
    if (scene.frame) X = scene.frame->body_point(X);
    ExactPoint exact{state_at(scene.motion, X, t), {}};
    if (vortex)
      exact.stress = stress_of(*vortex, *response, scene.material.density, X, t, exact.state.F);
    else  // P = tau, b = a
      exact.stress = {tau[i], cauchy_stress(tau[i], exact.state.F), exact.state.a};
    out.push_back(scene.frame ? seen_from(*scene.frame, exact, t) : exact);
  }
  return out;
}

}  // namespace assay::drivers
