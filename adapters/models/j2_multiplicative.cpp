// SPDX-License-Identifier: BSD-3-Clause
// J2 plasticity at finite strain after Simo (1992): F = Fe Fp, b_e = F Cp^-1 F^T, Kirchhoff stress tau = kappa ln J I +
// 2 mu dev e, e = ln(b_e)/2, n = (dev tau - beta)/|dev tau - beta|, |dev tau - beta| <= radius(p), dp/dt = sqrt(2/3)
// Lam, and the flow rule db_e/dt = l b_e + b_e l^T - 2 Lam V n V, V = b_e^(1/2). Without back stress V n V = n b_e.
// The back stress turns with R of F = R U: beta = R A R^T, dA/dt = (2/3) kinematic_modulus Lam R^T n R.
#include "adapters/models/j2_hardening.hpp"
#include "adapters/models/multiplicative_flow.hpp"

namespace assay::models {

class J2Multiplicative {
 public:
  static constexpr const char* name = "j2_multiplicative";
  static constexpr const char* doc =
      "J2 plasticity at finite strain, multiplicative, logarithmic elastic strain (Simo)";
  static constexpr std::uint32_t flags = ASSAY_NON_SMOOTH | ASSAY_USES_INCREMENT;
  static constexpr auto& parameters = j2_parameters;
  static constexpr auto& example = j2_example;
  static constexpr assay_state_variable state[] = {
      {"plastic_strain", "1", ASSAY_SCALAR, ASSAY_ROLE_PLAIN, "equivalent plastic strain p"},
      {"inverse_plastic_metric", "1", ASSAY_SYMMETRIC_TENSOR, ASSAY_ROLE_ROTATES_ITSELF, "Cp^-1 = (Fp^T Fp)^-1"},
      {"unrotated_back_stress", "Pa", ASSAY_SYMMETRIC_TENSOR, ASSAY_ROLE_ROTATES_ITSELF, "A = R^T beta R, F = R U"}};

  explicit J2Multiplicative(const double* p)
      : unit_(unit_of_stress(p[0])),
        elastic_(p[0] / unit_, p[1]),
        hardening_(p + 2, unit_),
        flow_(elastic_, hardening_) {
    hardening_.require_strength(elastic_.mu);
  }

  /// An initial stress is carried by an elastic strain, Cp^-1 = exp(2 e) at F = I; tr e then stands for ln J.
  void initial_state(const Tensor& stress, double* now) const {
    const Tensor cauchy = stress / unit_;
    hardening_.require_below_yield(cauchy, elastic_.mu);
    Tensor twice_strain = deviator(cauchy) / elastic_.mu;
    for (int i = 0; i < 3; ++i) twice_strain(i, i) += 2 * trace(cauchy) / (9 * elastic_.kappa);
    put_symmetric(exponential(twice_strain), now + 1);
  }

  /// Elastic steps leave the state alone, which lives in the reference configuration. Exactly objective: only C0, C1
  /// and the frame of F1 enter.
  template <class S>
  TensorOf<S> update(const IncrementOf<S>& step, const double* state0, S* state1) const {
    const bool backed = flow_.backed();
    const TensorOf<S> R = backed ? rotation_of(step.F1) : TensorOf<S>(TensorOf<S>::Identity());
    MultiplicativeStep<S> unrotated{right_cauchy_green(step.F0).template cast<S>(), step.F1,
                                    symmetric_from(state0 + 1).template cast<S>(),
                                    Tensor(symmetric_from(state0 + 7) / unit_).template cast<S>(), S(state0[0])};
    if (backed) unrotated.G1 = symmetric(TensorOf<S>(R.transpose() * step.F1));
    TensorOf<S> e = logarithmic_strain(unrotated.G1, unrotated.Cp_inverse);
    if (value_of(flow_.excess_of(unrotated, e)) > flow_.tolerance(state0[0])) {
      const MultiplicativeEnd<S> end = flow_.end_of(unrotated, e);
      e = end.e;
      state1[0] = end.p;
      put_symmetric(end.Cp_inverse, state1 + 1);
      put_symmetric(TensorOf<S>(S(unit_) * end.back), state1 + 7);
    }
    const TensorOf<S> sigma = S(unit_) * elastic_.hooke(e) * (S(1) / determinant(step.F1));
    return backed ? push_forward(R, sigma) : sigma;
  }

  /// In the frame of U; the logarithms are differentiated automatically.
  void rate(double, const Tensor& F, const Tensor& l, const Tensor& cauchy, const double* now, Tensor& cauchy_rate,
            double* now_rate) const {
    const PolarRates polar = polar_rates(F, l);
    const Tensor Cp_inverse = symmetric_from(now + 1), back = symmetric_from(now + 7) / unit_;
    const Tensor b = polar.U * Cp_inverse * polar.U, pushed = polar.U_rate * Cp_inverse * polar.U;
    const Tensor e = 0.5 * logarithm(b), from = flow_.relative(e, back);
    Tensor e_rate = derivative_along(half_logarithm, b, Tensor(pushed + pushed.transpose()));
    const double least = hardening_.radius(now[0]) - hardening_.tolerance(now[0], elastic_.mu);
    if (norm(from) >= least && contraction(from, e_rate) > 0) {
      const Tensor n = from / norm(from), V = exponential(e), flow = 2 * V * n * V;
      const Tensor e_flow = derivative_along(half_logarithm, b, flow);
      const double two_mu = 2 * elastic_.mu, hardening = hardening_.back() + hardening_.slope(now[0]);
      const double amount = two_mu * contraction(n, e_rate) / (two_mu * contraction(n, e_flow) + hardening);
      const Tensor inverse_U = inverse(polar.U);
      e_rate -= amount * e_flow;
      now_rate[0] = root_two_thirds * amount;
      put_symmetric(Tensor(-amount * inverse_U * flow * inverse_U), now_rate + 1);
      put_symmetric(Tensor(unit_ * hardening_.back() * amount * n), now_rate + 7);
    }
    cauchy_rate = polar.spin * cauchy - cauchy * polar.spin - trace(l) * cauchy +
                  unit_ * polar.R * elastic_.hooke(e_rate) * polar.R.transpose() / determinant(F);
  }

  /// Elastic energy kappa/2 (ln J)^2 + mu |dev e|^2.
  double energy(const Tensor& F, const double* now) const {
    return unit_ * elastic_.stored(logarithmic_strain(F, symmetric_from(now + 1)));
  }

 private:
  double unit_;  ///< of the stresses below [Pa]
  ElasticConstants elastic_;
  J2Hardening hardening_;
  MultiplicativeFlow flow_;
};

}  // namespace assay::models

ASSAY_MODEL(assay::models::J2Multiplicative, j2_multiplicative)
