// SPDX-License-Identifier: BSD-3-Clause
// Drucker-Prager plasticity with apex and non-associated flow at finite strain, in the Kirchhoff stress
// tau = kappa tr(e) I + 2 mu dev e:  f = sqrt(J2) + friction I1 - k,  g = sqrt(J2) + dilatancy I1. On the cone
// dp = Lam / sqrt(3); at the apex the volume strain dv flows; k = cohesion + hardening_modulus (p + v / (3 sqrt(3)
// dilatancy)), continuous where the two meet (de Souza Neto, Peric and Owen 2008, section 8.3).
#include "adapters/models/elastic_constants.hpp"
#include "adapters/models/logarithmic_flow.hpp"

namespace assay::models {

class DruckerPrager {
 public:
  static constexpr const char* name = "drucker_prager";
  static constexpr const char* doc = "Drucker-Prager cone with apex, non-associated, multiplicative";
  static constexpr std::uint32_t flags = ASSAY_NON_SMOOTH | ASSAY_USES_INCREMENT;
  static constexpr assay_parameter parameters[] = {
      youngs_modulus,
      poissons_ratio,
      {"cohesion", "Pa", required, 0, huge, "k of f = sqrt(J2) + friction I1 - k; tension positive"},
      {"friction", "1", required, 0, 0.577350269, "slope of the cone in (I1, sqrt(J2))"},
      {"dilatancy", "1", 0, 0, 0.577350269, "slope of the flow potential, at most friction"},
      {"hardening_modulus", "Pa", 0, 0, huge, "dk/dp; above 0 it needs dilatancy > 0 or friction = 0"}};
  static constexpr double example[] = {1e3, 0.3, 15, 0.2, 0.1, 20};
  static constexpr assay_state_variable state[] = {
      {"inverse_plastic_metric", "1", ASSAY_SYMMETRIC_TENSOR, ASSAY_ROLE_ROTATES_ITSELF,
       "Cp^-1 in the reference configuration, b_e = F Cp^-1 F^T"},
      {"p", "1", ASSAY_SCALAR, ASSAY_ROLE_PLAIN, "equivalent plastic strain of the cone, Lam / sqrt(3)"},
      {"apex_strain", "1", ASSAY_SCALAR, ASSAY_ROLE_PLAIN, "plastic volume strain of the apex"}};

  explicit DruckerPrager(const double* p)
      : unit_(unit_of_stress(p[0])),
        elastic_(p[0] / unit_, p[1]),
        cohesion_(p[2] / unit_),
        friction_(p[3]),
        dilatancy_(p[4]),
        hardening_(p[5] / unit_) {
    if (dilatancy_ > friction_) throw Failure{"dilatancy must not exceed friction: plastic work would be negative"};
    if (friction_ == 0 && !(cohesion_ + hardening_ >= least_strength * elastic_.mu))
      throw Failure{"cohesion must be at least 1e-8 of the shear modulus where friction and hardening_modulus are 0"};
    if (hardening_ > 0 && friction_ > 0 && !(dilatancy_ > 0)) {
      throw Failure{"hardening_modulus > 0 needs dilatancy > 0, by which the apex hardens"};
    }
    if (dilatancy_ > 0) apex_hardening_ = hardening_ / (3 * root3 * dilatancy_);
    cone_slope_ = elastic_.mu + 9 * elastic_.kappa * friction_ * dilatancy_ + hardening_ / root3;
  }

  /// Elastic strain of the initial stress, J = 1: Cp^-1 = exp(2 e).
  void initial_state(const Tensor& cauchy, double* out) const {
    const Tensor stress = symmetric(cauchy) / unit_;
    Tensor e = deviator(stress) / (2 * elastic_.mu);
    e.diagonal().array() += trace(stress) / (9 * elastic_.kappa);
    const std::array<double, 2> fresh{};
    if (!is_elastic(e, fresh)) throw Failure{"the initial stress lies outside the cone"};
    put_symmetric(exponential(Tensor(2 * e)), out);
  }

  template <class S>
  TensorOf<S> update(const IncrementOf<S>& step, const double* state0, S* state1) const {
    const TensorOf<S> e = flow_step<2, true>(step, state0, state1, *this).e;
    const S J = determinant(step.F1);
    return (S(unit_) / J) * elastic_.hooke(e);
  }

  template <class S>
  bool is_elastic(const TensorOf<S>& trial, const std::array<S, 2>& scalars) const {
    const double shear = root_J2(deviator(values_of(trial))), k = value_of(strength(scalars));
    const double tension = 3 * friction_ * elastic_.kappa * value_of(trace(trial));
    return shear + tension - k <= 1e-13 * (k + shear + std::abs(tension));
  }

  /// Exact return to the cone or to the apex, where the cone's would leave sqrt(J2) negative.
  template <class S>
  FlowIncrement<S, 2> operator()(const TensorOf<S>& trial, double, const std::array<S, 2>& scalars) const {
    if (is_elastic(trial, scalars)) return {};
    const TensorOf<S> shape = deviator(trial);
    const S excess = S(3 * friction_ * elastic_.kappa) * trace(trial) - strength(scalars);
    return return_to_surface(shape, root_J2(shape), excess);
  }

  /// Flow where f = 0 to 1e-9 and the trial stress moves outward; at the apex the rates are returned as strains are.
  /// What an integrator drifts from f = 0 decays with the strain, so that it does not switch at every step.
  void rate(double, const Tensor& F, const Tensor& l, const Tensor&, const double* at, Tensor& cauchy_rate,
            double* state_rate) const {
    const Tensor A = symmetric_from(at);
    const Moving trial = trial_strain(F, l, A);
    const FlowIncrement<double, 2> flow = flow_rate(trial.value, trial.rate, symmetric(l).norm(), at + 6);
    cauchy_rate = unit_ * (elastic_.hooke(Tensor(trial.rate - flow.strain)) - trace(l) * elastic_.hooke(trial.value)) /
                  determinant(F);
    put_symmetric(flow_rate_of_state(F, A, flow.strain), state_rate);
    for (std::size_t i = 0; i < 2; ++i) state_rate[6 + i] = flow.scalars[i];
  }

  /// W = kappa/2 tr(e)^2 + mu dev e : dev e [J/m^3].
  double energy(const Tensor& F, const double* at) const {
    return unit_ * elastic_.stored(logarithmic_strain(F, symmetric_from(at)));
  }

 private:
  static constexpr double root3 = 1.7320508075688772935, on_surface = 1e-9;

  /// sqrt(J2) = mu sqrt(2 dev e : dev e) [Pa].
  template <class S>
  S root_J2(const TensorOf<S>& shape) const {
    return S(1.4142135623730950488 * elastic_.mu) * norm(shape);
  }

  template <class S>
  S strength(const std::array<S, 2>& scalars) const {
    return S(cohesion_) + S(hardening_) * scalars[0] + S(apex_hardening_) * scalars[1];
  }

  /// sqrt(J2) = shear and friction I1 - k = excess of the trial state; shear + excess > 0.
  template <class S>
  FlowIncrement<S, 2> return_to_surface(const TensorOf<S>& shape, const S& shear, const S& excess) const {
    FlowIncrement<S, 2> flow;
    flow.elastic = false;
    S volume(0);
    const S Lam = (shear + excess) * S(1 / cone_slope_);
    if (value_of(shear) >= elastic_.mu * value_of(Lam)) {
      flow.strain = (S(elastic_.mu) * Lam / shear) * shape;
      flow.scalars[0] = Lam * S(1 / root3);
      volume = S(3 * dilatancy_) * Lam;
    } else {
      flow.strain = shape;
      volume = flow.scalars[1] = excess * S(1 / (3 * friction_ * elastic_.kappa + apex_hardening_));
    }
    for (int i = 0; i < 3; ++i) flow.strain(i, i) += volume * S(1.0 / 3);
    return flow;
  }

  FlowIncrement<double, 2> flow_rate(const Tensor& e, const Tensor& trial, double pull, const double* scalars) const {
    const Tensor shape = deviator(e), shape_rate = deviator(trial);
    const double shear = root_J2(shape), tension = 3 * friction_ * elastic_.kappa * trace(e);
    const double k = strength(std::array<double, 2>{scalars[0], scalars[1]}), scale = k + shear + std::abs(tension);
    const double f = shear + tension - k, excess_rate = 3 * friction_ * elastic_.kappa * trace(trial);
    if (f < -on_surface * scale) return {};
    if (shear <= on_surface * scale) {  // the apex
      if (root_J2(shape_rate) + excess_rate <= 0) return {};
      const Tensor towards = shape_rate + pull * shape;
      return return_to_surface(towards, root_J2(towards), excess_rate + pull * (tension - k));
    }
    const double loading = 2 * elastic_.mu * elastic_.mu * contraction(shape, shape_rate) / shear + excess_rate;
    FlowIncrement<double, 2> flow;
    if (!(loading > 0)) return flow;
    const double Lam = (loading + pull * f) / cone_slope_;
    flow.elastic = false;
    flow.strain = (elastic_.mu * Lam / shear) * shape;
    flow.strain.diagonal().array() += dilatancy_ * Lam;
    flow.scalars[0] = Lam / root3;
    return flow;
  }

  double unit_;  ///< of the stresses below [Pa]
  ElasticConstants elastic_;
  double cohesion_, friction_, dilatancy_, hardening_, apex_hardening_ = 0, cone_slope_;
};

}  // namespace assay::models

ASSAY_MODEL(assay::models::DruckerPrager, drucker_prager)
