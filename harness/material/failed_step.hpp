// SPDX-License-Identifier: BSD-3-Clause
// The one step of one point at which a material failed: all that is needed to take it again.
#pragma once

#include <cstddef>
#include <vector>

#include "harness/material/material.hpp"
#include "harness/numeric/tensor.hpp"

namespace assay {

/// Arguments of `update` for one point: a pure call, so that the same arguments fail again.
struct FailedStep {
  double t = 0, dt = 0;             ///< beginning and length [s]
  Tensor F0 = Tensor::Identity();   ///< deformation gradient at t [1]
  Tensor F1 = Tensor::Identity();   ///< at t + dt [1]
  std::vector<double> state0 = {};  ///< every component of the point's state at t, in declared order
};

/// Point p of a batch of n: F0, F1 9 * n, state0 state_size * n, component-major as in the ABI.
inline FailedStep failed_step(double t, double dt, std::size_t n, std::size_t p, const double* F0, const double* F1,
                              const double* state0, std::size_t state_size) {
  FailedStep step{t, dt, {}, {}, std::vector<double>(state_size)};
  for (int c = 0; c < 9; ++c) {
    component(step.F0, c) = F0[static_cast<std::size_t>(c) * n + p];
    component(step.F1, c) = F1[static_cast<std::size_t>(c) * n + p];
  }
  for (std::size_t c = 0; c < state_size; ++c) step.state0[c] = state0[c * n + p];
  return step;
}

/// Takes the step again.
inline UpdateReport take_again(const Material& material, const FailedStep& step) {
  double F0[9], F1[9], cauchy[9];
  for (int c = 0; c < 9; ++c) F0[c] = component(step.F0, c), F1[c] = component(step.F1, c);
  std::vector<double> state1(step.state0.size());
  return material.update(step.t, step.dt, 1, F0, F1, step.state0.data(), state1.data(), cauchy);
}

}  // namespace assay
