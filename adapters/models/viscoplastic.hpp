// SPDX-License-Identifier: BSD-3-Clause
// Viscoplasticity of the power law at finite strain, with a threshold (Perzyna 1966) or without (Norton 1929):
//   tau_K = kappa ln J I + 2 mu dev e,  sigma_eq = sqrt(3/2) |dev tau_K|,  f = sigma_eq - yield_stress - H p,
//   dp/dt = reference_rate <f / reference_stress>^exponent,  D = dp/dt (3/2) dev tau_K / sigma_eq.
#pragma once

#include <algorithm>

#include "adapters/models/elastic_constants.hpp"
#include "adapters/models/logarithmic_flow.hpp"

namespace assay::models {

inline constexpr assay_parameter reference_rate{
    "reference_rate", "1/s", required, 0, huge, "rate of p where the overstress is reference_stress"};
inline constexpr assay_parameter reference_stress{"reference_stress",       "Pa", required, tiny, huge,
                                                  "scale of the overstress"};
inline constexpr assay_parameter rate_exponent{"exponent", "1", 1, 1, 100, "exponent of the power law"};
inline constexpr assay_state_variable inverse_plastic_metric{"inverse_plastic_metric", "1", ASSAY_SYMMETRIC_TENSOR,
                                                             ASSAY_ROLE_ROTATES_ITSELF,
                                                             "Cp^-1 in the reference configuration, b_e = F Cp^-1 F^T"};
inline constexpr assay_state_variable viscoplastic_strain{"p", "1", ASSAY_SCALAR, ASSAY_ROLE_PLAIN,
                                                          "equivalent viscoplastic strain"};
/// Just above the threshold p grows by less than its last bit: the branch of a step needs a name of its own. A step in
/// which the flow comes to its end has one too, or the flow that is left after a reversal would be stepped over.
inline constexpr assay_state_variable flow_regime{
    "flowing", "regime", ASSAY_SCALAR, ASSAY_ROLE_PLAIN,
    "regime of the last step: 0 elastic, 1 flow, 2 elastic only at the end of the step"};

/// What a model class of either kind does (plugin.hpp); the model adds its name, parameters and state.
template <bool has_threshold>
class PowerLawFlow {
 public:
  ElasticConstants elastic;
  double rate_scale, stress_scale, exponent;  ///< [1/s], [unit], [1]
  double yield_stress = 0, hardening = 0;     ///< [unit], zero where there is no threshold
  double unit = 1;                            ///< of all stresses here [Pa]

  static void initial_state(const Tensor& cauchy, double* state) {
    require_stress_free(cauchy);
    state[0] = state[1] = state[2] = 1;
  }

  /// Cauchy stress at the end of the step [Pa].
  template <class S>
  TensorOf<S> update(const IncrementOf<S>& step, const double* state0, S* state1) const {
    const FlowStep<S> end = flow_step<1, has_threshold>(step, state0, state1, *this);
    if constexpr (has_threshold) state1[7] = S(end.flows ? 1 : state0[7] == 1 && ceases(step, state0) ? 2 : 0);
    return S(unit) * cauchy(determinant(step.F1), end.e);
  }

  void rate(double, const Tensor& F, const Tensor& l, const Tensor&, const double* state, Tensor& cauchy_rate,
            double* state_rate) const {
    const Tensor A = symmetric_from(state);
    const Moving trial = trial_strain(F, l, A);
    const Tensor shape = deviator(trial.value);
    const double size = equivalent_stress(shape), f = size - yield_stress - hardening * state[6];
    const double p_rate = f > 0 ? rate_scale * std::pow(f / stress_scale, exponent) : 0.0;
    const Tensor D = f > 0 ? Tensor((3 * elastic.mu * p_rate / size) * shape) : Tensor(Tensor::Zero());
    const double J = determinant(F), expansion = trace(l);
    const Tensor e_rate = trial.rate - D, kirchhoff_shape = 2 * elastic.mu * shape;
    cauchy_rate = (2 * elastic.mu * deviator(e_rate) - expansion * kirchhoff_shape) / J;
    cauchy_rate.diagonal().array() += elastic.kappa * expansion * (1 - std::log(J)) / J;
    cauchy_rate *= unit;
    put_symmetric(flow_rate_of_state(F, A, D), state_rate);
    state_rate[6] = p_rate;
  }

  /// W = kappa/2 ln^2 J + mu dev e : dev e [J/m^3].
  double energy(const Tensor& F, const double* state) const {
    const double ln_J = std::log(determinant(F));
    const Tensor shape = deviator(logarithmic_strain(F, symmetric_from(state)));
    return unit * (0.5 * elastic.kappa * ln_J * ln_J + elastic.mu * contraction(shape, shape));
  }

  template <class S>
  bool is_elastic(const TensorOf<S>& trial, const std::array<S, 1>& scalars) const {
    return !(value_of(equivalent_stress(deviator(trial))) > yield_stress + hardening * value_of(scalars[0]));
  }

  /// Implicit Euler: f + c (f / stress_scale)^exponent = f_trial, c = (3 mu + H) length rate_scale.
  template <class S>
  FlowIncrement<S, 1> operator()(const TensorOf<S>& trial, double length, const std::array<S, 1>& scalars) const {
    FlowIncrement<S, 1> flow;
    const double slope = 3 * elastic.mu + hardening, c = slope * length * rate_scale;
    const TensorOf<S> shape = deviator(trial);
    const S size = equivalent_stress(shape), f_trial = size - S(yield_stress) - S(hardening) * scalars[0];
    if (!(c > 0)) return flow;
    if (!(value_of(f_trial) > 0)) {
      if (has_threshold || exponent > 1) return flow;
      flow.elastic = false;  // linear and at rest: the flow is zero, its slope is not
      flow.strain = S(c / (stress_scale + c)) * shape;
      return flow;
    }
    const S relaxed = relaxation(f_trial, c);
    flow.elastic = false;
    flow.scalars[0] = relaxed * S(1 / slope);
    flow.strain = (S(3 * elastic.mu / slope) * relaxed / size) * shape;
    return flow;
  }

 private:
  /// Whether the flow of the step before lasts for more than a trifle of this one, which ends elastic.
  template <class S>
  bool ceases(const IncrementOf<S>& step, const double* state0) const {
    constexpr double trifle = 1e-8;
    const Tensor A = symmetric_from(state0);
    const auto excess = [&](const Tensor& F) {
      return equivalent_stress(deviator(logarithmic_strain(F, A))) - yield_stress - hardening * state0[6];
    };
    const double before = excess(step.F0), after = excess(values_of(step.F1));
    return before > trifle * (before - after);
  }

  template <class S>
  TensorOf<S> cauchy(const S& J, const TensorOf<S>& e) const {
    using std::log;
    TensorOf<S> sigma = (S(2 * elastic.mu) / J) * deviator(e);
    const S mean = S(elastic.kappa) * log(J) / J;
    for (int i = 0; i < 3; ++i) sigma(i, i) += mean;
    return sigma;
  }

  /// sqrt(3/2) |2 mu dev e| [unit].
  template <class S>
  S equivalent_stress(const TensorOf<S>& shape) const {
    return S(2.4494897427831780982 * elastic.mu) * norm(shape);
  }

  /// f_trial - f [unit]. The starting point bounds f from above by at most a factor of two, and the equation is convex:
  /// Newton's iteration descends to the root from there, however stiff the step.
  template <class S>
  S relaxation(const S& f_trial, double c) const {
    constexpr int most = 60;
    const double load = value_of(f_trial);
    double f = std::min(load, stress_scale * std::pow(load / c, 1 / exponent)), flowing = 0;
    for (int k = 0; k < most; ++k) {
      flowing = c * std::pow(f / stress_scale, exponent);
      const double change = (f + flowing - load) / (1 + exponent * flowing / f);
      f -= change;
      flowing *= 1 - exponent * change / (f + change);
      if (!(change > 1e-9 * f)) break;  // quadratic, and from above: the next change is round-off
    }
    const double slope = exponent * flowing / f;
    const double relaxed = flowing < 0.5 * load ? flowing : load - f;
    return S(relaxed) + S(slope / (1 + slope)) * S(f_trial - S(load));
  }
};

}  // namespace assay::models
