// SPDX-License-Identifier: BSD-3-Clause
// Inelastic flow at finite strain in logarithmic measures: b_e = F A F^T with A = Cp^-1 in the reference configuration,
// e = ln(b_e) / 2, and b_e-dot = l b_e + b_e l^T - 2 D b_e with a flow D coaxial with b_e, so that an implicit step of
// the flow is subtraction: e = e_trial - de (Weber and Anand 1990, Simo 1992).
#pragma once

#include "adapters/models/plugin.hpp"

namespace assay::models {

/// What a flow rule makes of a trial strain: the strain that flows, and the increments of N scalars of the state.
template <class S, int N>
struct FlowIncrement {
  bool elastic = true;
  TensorOf<S> strain = TensorOf<S>::Zero();
  std::array<S, N> scalars;

  FlowIncrement() { scalars.fill(S(0)); }
};

/// A = Cp^-1 (six components of the state) and the N scalars after it.
template <class S, int N>
struct FlowState {
  TensorOf<S> A;
  std::array<S, N> scalars;

  explicit FlowState(const double* state) : A(symmetric_from(state).template cast<S>()) {
    for (std::size_t i = 0; i < N; ++i) scalars[i] = S(state[6 + i]);
  }

  /// After `weight` times the increment at the deformation gradient F: b_e <- exp(-2 weight de) b_e.
  void flow(const TensorOf<S>& F, const FlowIncrement<S, N>& increment, double weight) {
    if (increment.elastic) return;
    A = symmetric(TensorOf<S>(inverse(F) * exponential(TensorOf<S>(S(-2 * weight) * increment.strain)) * F * A));
    for (std::size_t i = 0; i < N; ++i) scalars[i] += S(weight) * increment.scalars[i];
  }

  void put(S* state) const {
    put_symmetric(A, state);
    for (std::size_t i = 0; i < N; ++i) state[6 + i] = scalars[i];
  }
};

/// Whether what is extrapolated from the flow of early_e (at G) turns the strain left at F into its opposite.
template <class S>
bool flows_back(const TensorOf<S>& F, const TensorOf<S>& e, const TensorOf<S>& G, const TensorOf<S>& early_e,
                const TensorOf<S>& flowed) {
  const Tensor shape = deviator(values_of(early_e)), part = deviator(values_of(flowed));
  if (contraction(part, part) < 0.17 * contraction(shape, shape)) return false;  // (g / (1 - g))^2
  const Tensor there = values_of(F) * inverse(values_of(G));
  return trace(Tensor(there * shape * inverse(there) * deviator(values_of(e)))) < 0;
}

/// What a step leaves behind: e at its end, and whether anything flowed.
template <class S>
struct FlowStep {
  TensorOf<S> e;
  bool flows;
};

/// One step of the flow: two implicit stages, at g and at 1 with g = 1 - 1/sqrt(2): second order, L-stable (Alexander
/// 1977). At g the metric is (1 - g) C0 + g C1, which no rotation of the frame changes. Where what the first stage
/// extrapolates would have to flow back (a jump that relaxes within the step), implicit Euler takes the whole step.
/// With `has_threshold` a step whose end is elastic is elastic: the state keeps its bits.
/// rule(e_trial, length of the stage [s], scalars) is the flow rule's implicit step, and rule.is_elastic(e_trial,
/// scalars) says whether nothing would flow.
template <int N, bool has_threshold, class S, class Rule>
FlowStep<S> flow_step(const IncrementOf<S>& step, const double* state0, S* state1, const Rule& rule) {
  constexpr double g = 0.29289321881345247560;
  const FlowState<S, N> before(state0);
  FlowState<S, N> after = before;
  TensorOf<S> whole_e;
  if constexpr (has_threshold) {
    whole_e = logarithmic_strain(step.F1, before.A);
    if (rule.is_elastic(whole_e, before.scalars)) return {whole_e, false};
  }
  const TensorOf<S> C0 = right_cauchy_green(step.F0).template cast<S>();
  const TensorOf<S> C1 = right_cauchy_green(step.F1);
  const TensorOf<S> G = upper_root(TensorOf<S>(S(1 - g) * C0 + S(g) * C1));
  const TensorOf<S> early_e = logarithmic_strain(G, before.A);
  const FlowIncrement<S, N> early = rule(early_e, g * step.dt, before.scalars);
  after.flow(G, early, (1 - g) / g);
  TensorOf<S> e = logarithmic_strain(step.F1, after.A);
  FlowIncrement<S, N> late = rule(e, g * step.dt, after.scalars);
  const bool back = !early.elastic && (late.elastic || flows_back(step.F1, e, G, early_e, early.strain));
  if (back) {
    if (!has_threshold) whole_e = logarithmic_strain(step.F1, before.A);
    late = rule(whole_e, step.dt, before.scalars);
    after = before;
    e = whole_e;
  }
  after.flow(step.F1, late, 1);
  after.put(state1);
  return {e - late.strain, true};
}

/// e and de/dt along the motion while nothing flows.
inline Moving trial_strain(const Tensor& F, const Tensor& l, const Tensor& A) {
  const Tensor b = push_forward(F, A);
  return moving_along(half_logarithm, b, Tensor(l * b + b * l.transpose()));
}

/// dA/dt = -2 F^-1 D F A under the flow D.
inline Tensor flow_rate_of_state(const Tensor& F, const Tensor& A, const Tensor& D) {
  return symmetric(Tensor(-2 * inverse(F) * D * F * A));
}

}  // namespace assay::models
