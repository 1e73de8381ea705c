// SPDX-License-Identifier: BSD-3-Clause
// Zener's solid at finite strain: second Piola-Kirchhoff stress S = mu (I - C^-1) + lambda ln J C^-1 + S_v, dS_v/dt +
// S_v / relaxation_time = viscous_ratio mu d/dt(I - C^-1); sigma = F S F^T / J.
#include "adapters/models/elastic_constants.hpp"

namespace assay::models {

class Zener {
 public:
  static constexpr const char* name = "zener";
  static constexpr const char* doc = "finite viscoelasticity: a neo-Hookean spring beside a Maxwell element";
  static constexpr std::uint32_t flags = ASSAY_RATE_DEPENDENT | ASSAY_USES_INCREMENT;
  static constexpr assay_parameter parameters[] = {
      youngs_modulus,
      poissons_ratio,
      {"viscous_ratio", "1", 1.0, 0.0, huge, "instantaneous shear modulus over mu, minus 1"},
      {"relaxation_time", "s", required, tiny, huge, "relaxation time of the viscous stress"}};
  static constexpr double example[] = {1e3, 0.3, 1.5, 0.3};
  static constexpr assay_state_variable state[] = {
      {"viscous_stress", "Pa", ASSAY_SYMMETRIC_TENSOR, ASSAY_ROLE_ROTATES_ITSELF,
       "second Piola-Kirchhoff stress of the Maxwell element at the beginning of the step"}};

  explicit Zener(const double* p) : elastic_(p[0], p[1]), viscous_(p[2] * elastic_.mu), time_(p[3]) {}

  /// S_v1 = exp(-D) S_v0 + viscous_ratio mu (C0^-1 - C1^-1) (1 - exp(-D))/D, D = dt / relaxation_time: exact where C^-1
  /// is linear in time, second order otherwise, stable at any step, and exactly objective.
  template <class S>
  TensorOf<S> update(const IncrementOf<S>& step, const double* state0, S* state1) const {
    const double D = step.dt / time_, share = D > 0 ? -std::expm1(-D) / D : 1;
    const TensorOf<S> C_inverse = inverse_of_C(step.F1);
    const TensorOf<S> change = inverse_of_C(step.F0).template cast<S>() - C_inverse;
    const TensorOf<S> S_v = (std::exp(-D) * symmetric_from(state0)).template cast<S>() + S(viscous_ * share) * change;
    put_symmetric(S_v, state1);
    return stress(step.F1, S_v);
  }

  void rate(double, const Tensor& F, const Tensor& l, const Tensor& cauchy, const double* six, Tensor& cauchy_rate,
            double* six_rate) const {
    const Tensor d = symmetric(l), S_v = symmetric_from(six), F_inverse = inverse(F);
    const double J = determinant(F);
    const Tensor C_inverse_rate = -2 * F_inverse * d * F_inverse.transpose();
    const Tensor S_v_rate = -S_v / time_ - viscous_ * C_inverse_rate;
    put_symmetric(S_v_rate, six_rate);
    // F (dS/dt) F^T, the rest of S being mu (I - C^-1) + lambda ln J C^-1.
    const Tensor pushed = elastic_.hooke(d) - 2 * elastic_.lambda * std::log(J) * d + F * S_v_rate * F.transpose();
    cauchy_rate = l * cauchy + cauchy * l.transpose() - trace(d) * cauchy + pushed / J;
  }

 private:
  template <class S>
  static TensorOf<S> inverse_of_C(const TensorOf<S>& F) {
    const TensorOf<S> F_inverse = inverse(F);
    return left_cauchy_green(F_inverse);
  }

  /// J sigma = lambda ln J I + mu (b - I) + F S_v F^T.
  template <class S>
  TensorOf<S> stress(const TensorOf<S>& F, const TensorOf<S>& S_v) const {
    using std::log;
    const S J = determinant(F);
    TensorOf<S> kirchhoff = S(elastic_.mu) * left_cauchy_green(F) + push_forward(F, S_v);
    const S added = S(elastic_.lambda) * log(J) - S(elastic_.mu);
    for (int i = 0; i < 3; ++i) kirchhoff(i, i) += added;
    return (S(1) / J) * kirchhoff;
  }

  ElasticConstants elastic_;
  double viscous_, time_;  // viscous_ratio mu [Pa]; relaxation time [s]
};

}  // namespace assay::models

ASSAY_MODEL(assay::models::Zener, zener)
