// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/march.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "harness/numeric/norms.hpp"

namespace assay::check {

Tensor turn_about(const Vector3& axis, double angle) {
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

Tensor Space::within(const Tensor& A) const {
  Tensor result = A;
  for (int c = 0; c < 9; ++c) {
    if (!has(c)) component(result, c) = 0;
  }
  return result;
}

Tensor Space::turn(double angle) const {
  if (is_plane_) return rotation_about_z(angle);
  return turn_about({1, 2, 3}, angle);
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

std::vector<Tensor> Batch::step(const Material& material, double t, double dt, const std::vector<Tensor>& F0,
                                const std::vector<Tensor>& F1) {
  const std::size_t n = states.size(), size = material.state_size();
  std::vector<double> before(9 * n), after(9 * n), state0(size * n), state1(size * n), cauchy(9 * n);
  for (std::size_t p = 0; p < n; ++p) {
    put_tensor(F0[p], before.data(), n, p);
    put_tensor(F1[p], after.data(), n, p);
    put_point(states[p], state0.data(), n, p);
  }
  checked_update(material, 0, t, dt, n, before.data(), after.data(), state0.data(), state1.data(), cauchy.data());
  std::vector<Tensor> stresses;
  for (std::size_t p = 0; p < n; ++p) {
    states[p] = point_of(state1.data(), n, p, size);
    stresses.push_back(tensor_at(cauchy.data(), n, p));
  }
  return stresses;
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
