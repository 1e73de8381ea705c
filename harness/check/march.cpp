// SPDX-License-Identifier: BSD-3-Clause
#include "harness/check/march.hpp"

#include <algorithm>

#include "harness/material/checked_update.hpp"
#include "harness/numeric/stable_norm.hpp"

namespace assay::check {

Point stepped(const Material& material, double t, double dt, const Tensor& F0, const Tensor& F1,
              const std::vector<double>& state0) {
  double before[9], after[9], sigma[9];
  for (int c = 0; c < 9; ++c) before[c] = component(F0, c), after[c] = component(F1, c);
  Point end{Tensor::Zero(), std::vector<double>(state0.size())};
  checked_update(material, 0, t, dt, 1, before, after, state0.data(), end.state.data(), sigma);
  for (int c = 0; c < 9; ++c) component(end.cauchy, c) = sigma[c];
  return end;
}

bool takes(const Material& material, const FailedStep& step) {
  try {
    stepped(material, step.t, step.dt, step.F0, step.F1, step.state0);
    return true;
  } catch (const MaterialFailure&) {
    return false;
  }
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
      result.largest = std::max(result.largest, now.cauchy.cwiseAbs().maxCoeff());
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
