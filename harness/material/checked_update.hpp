// SPDX-License-Identifier: BSD-3-Clause
// `update` for callers that cannot go on without it.
#pragma once

#include "harness/material/material.hpp"
#include "harness/material/material_failure.hpp"

namespace assay {

/// Material::update of n points. Throws MaterialFailure with the first point that failed, at t + dt and `xi`.
inline void checked_update(const Material& material, double xi, double t, double dt, std::size_t n, const double* F0,
                           const double* F1, const double* state0, double* state1, double* cauchy) {
  const UpdateReport report = material.update(t, dt, n, F0, F1, state0, state1, cauchy);
  if (report.worst != ASSAY_FAILED) return;
  MaterialFailure failure(report.message, xi, t + dt,
                          failed_step(material, t, dt, n, report.worst_point, F0, F1, state0));
  failure.not_finite = report.not_finite;
  failure.final = report.dt_factor == 0;
  throw failure;
}

/// Stress [Pa] and state of one point.
struct StepEnd {
  Tensor cauchy = Tensor::Zero();
  std::vector<double> state;
};

/// One step of one point. Throws MaterialFailure.
inline StepEnd stepped(const Material& material, double t, double dt, const Tensor& F0, const Tensor& F1,
                       const std::vector<double>& state0, double xi = 0) {
  double sigma[9];
  StepEnd end{Tensor::Zero(), std::vector<double>(state0.size())};
  checked_update(material, xi, t, dt, 1, nine_of(F0).data(), nine_of(F1).data(), state0.data(), end.state.data(),
                 sigma);
  end.cauchy = tensor_of(sigma);
  return end;
}

inline StepEnd stepped(const Material& material, const FailedStep& step) {
  return stepped(material, step.t, step.dt, step.F0, step.F1, step.state0);
}

}  // namespace assay
