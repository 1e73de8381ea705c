// SPDX-License-Identifier: BSD-3-Clause
// A Mooney-Rivlin spring beside a Maxwell element of the same law, for tests: smooth, with history, and with a stress
// across the plane of a simple shear.
#pragma once

#include <memory>

#include "adapters/models/plugin.hpp"
#include "harness/material/material.hpp"

namespace assay {

/// Second Piola-Kirchhoff stress S = S_M(C) + S_v with S_M = 2 c1 I + 2 c2 (tr C I - C) - (2 c1 + 4 c2) C^-1 and
/// dS_v/dt = -S_v/relaxation_time + ratio dS_M/dt. For motions with J = 1: nothing resists a change of volume.
class RelaxingMooney {
 public:
  using Tensor = models::Tensor;
  static constexpr const char* name = "relaxing_mooney";
  static constexpr const char* doc = "for tests";
  static constexpr std::uint32_t flags = ASSAY_RATE_DEPENDENT | ASSAY_USES_INCREMENT;
  static constexpr assay_parameter parameters[] = {
      {"c1", "Pa", 120, 0, 1e12, "of tr C"},
      {"c2", "Pa", 80, 0, 1e12, "of the second invariant"},
      {"ratio", "1", 1.5, 0, 1e12, "of the Maxwell element"},
      {"relaxation_time", "s", 0.3, 1e-12, 1e12, "of the Maxwell element"}};
  static constexpr double example[] = {120, 80, 1.5, 0.3};
  static constexpr assay_state_variable state[] = {
      {"viscous_stress", "Pa", ASSAY_SYMMETRIC_TENSOR, ASSAY_ROLE_ROTATES_ITSELF, "S_v"}};

  explicit RelaxingMooney(const double* p) : c1_(p[0]), c2_(p[1]), ratio_(p[2]), time_(p[3]) {}

  template <class S>
  models::TensorOf<S> update(const models::IncrementOf<S>& step, const double* state0, S* state1) const {
    const double D = step.dt / time_, share = D > 0 ? -std::expm1(-D) / D : 1;
    const models::TensorOf<S> spring = spring_of(step.F1), before = spring_of(step.F0).template cast<S>();
    const models::TensorOf<S> S_v =
        (std::exp(-D) * models::symmetric_from(state0)).template cast<S>() + S(ratio_ * share) * (spring - before);
    models::put_symmetric(S_v, state1);
    const models::TensorOf<S> all = spring + S_v;
    return (S(1) / models::determinant(step.F1)) * models::push_forward(step.F1, all);
  }

  void rate(double, const Tensor& F, const Tensor& l, const Tensor& cauchy, const double* six, Tensor& cauchy_rate,
            double* six_rate) const {
    const Tensor d = 0.5 * (l + l.transpose()), C = F.transpose() * F, C_inverse = models::inverse(C);
    const Tensor C_rate = 2 * F.transpose() * d * F;
    const Tensor spring_rate =
        2 * c2_ * (C_rate.trace() * Tensor::Identity() - C_rate) + (2 * c1_ + 4 * c2_) * C_inverse * C_rate * C_inverse;
    const Tensor S_v_rate = -models::symmetric_from(six) / time_ + ratio_ * spring_rate;
    models::put_symmetric(S_v_rate, six_rate);
    cauchy_rate = l * cauchy + cauchy * l.transpose() - d.trace() * cauchy +
                  F * (spring_rate + S_v_rate) * F.transpose() / models::determinant(F);
  }

 private:
  template <class S>
  models::TensorOf<S> spring_of(const models::TensorOf<S>& F) const {
    const models::TensorOf<S> C = F.transpose() * F;
    models::TensorOf<S> spring = S(-2 * c2_) * C - S(2 * c1_ + 4 * c2_) * models::inverse(C);
    for (int i = 0; i < 3; ++i) spring(i, i) += S(2 * c1_) + S(2 * c2_) * C.trace();
    return spring;
  }

  double c1_, c2_, ratio_, time_;
};

inline std::shared_ptr<const Material> relaxing_mooney() {
  return std::make_shared<const Material>(&models::table_of<RelaxingMooney>(), std::map<std::string, double>{});
}

}  // namespace assay
