// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/march.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "harness/numeric/norms.hpp"

namespace assay::check {

Tensor Space::within(const Tensor& A) const {
  Tensor result = A;
  for (int c = 0; c < 9; ++c) {
    if (!has(c)) component(result, c) = 0;
  }
  return result;
}

Tensor Space::turn(double angle) const {
  if (is_plane_) return rotation_about_z(angle);
  return Eigen::AngleAxisd(angle, Vector3(1, 2, 3).normalized()).toRotationMatrix();
}

Tensor Space::stretch(double amplitude, double s) const {
  Tensor A, B;
  A << 1, 0.4, -0.3, 0.4, -0.5, 0.2, -0.3, 0.2, 0.3;
  B << -0.2, 0.5, 0.1, 0.5, 0.6, -0.4, 0.1, -0.4, -0.3;
  return within(Tensor::Identity() + amplitude * (std::sin(1.5 * std::numbers::pi * s) * A + s * s * B));
}

Tensor Space::equal_stretches(double amplitude, bool three, double difference) const {
  const double other = three ? amplitude : -0.5 * amplitude;
  Vector3 stretches(1 + amplitude, 1 + amplitude + difference, 1 + other - (three ? difference : 0));
  if (is_plane_) std::swap(stretches(1), stretches(2));
  return rotated(turn(0.7), stretches.asDiagonal());
}

Point hold(const Material& material, double t, double length, const Tensor& F, Point from, int steps) {
  for (int k = 0; k < steps; ++k) from = stepped(material, t, length, F, F, from.state);
  return from;
}

Point hold_until(const Material& material, double time, const Tensor& F, Point from, int steps) {
  for (int k = 0; k < steps; ++k) from = stepped(material, time * k / steps, time / steps, F, F, from.state);
  return from;
}

bool takes(const Material& material, const FailedStep& step) {
  return if_taken([&] { return stepped(material, step), true; }, false);
}

March march(const Material& material, const Loading& loading, const MarchOptions& options) {
  March result;
  Point now{Tensor::Zero(), options.state};
  Tensor F0 = loading.F(0);
  const double dt = options.phase_length / options.steps;
  for (int phase = 0; phase < loading.phases; ++phase) {
    for (int k = 0; k < options.steps; ++k) {
      const Tensor F1 = loading.F(phase + (k + 1.0) / options.steps);
      const double t = options.begin + options.phase_length * phase + dt * k;
      if (phase + 1 == loading.phases && k + 1 == options.steps) result.last = {t, dt, F0, F1, now.state};
      now = stepped(material, t, dt, F0, F1, now.state);
      result.largest = std::max(result.largest, size_of(now.cauchy));
      result.sizes.push_back(stable_norm(now.cauchy));
      F0 = F1;
    }
    result.marks.push_back(now);
  }
  return result;
}

std::vector<double> state_at_rest(const Material& material, double pressure, const Vector3& direction) {
  std::vector<double> cauchy(9, 0.0);
  for (const std::size_t c : {0u, 4u, 8u}) cauchy[c] = -pressure;
  return material.initial_state(1, cauchy, std::vector<double>{direction.x(), direction.y(), direction.z()});
}

}  // namespace assay::check
