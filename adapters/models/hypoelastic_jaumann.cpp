// SPDX-License-Identifier: BSD-3-Clause
// Hypoelasticity with the Jaumann rate of the Cauchy stress: dsigma/dt - w sigma + sigma w = lambda tr(d) I + 2 mu d.
#include "adapters/models/baselines.hpp"

namespace assay::models {

class HypoelasticJaumann : public ElasticModel {
 public:
  using ElasticModel::ElasticModel;
  static constexpr const char* name = "hypoelastic_jaumann";
  static constexpr const char* doc = "hypoelasticity, Jaumann rate of the Cauchy stress";
  static constexpr std::uint32_t flags = ASSAY_USES_INCREMENT;
  static constexpr assay_state_variable state[] = {
      {"stress", "Pa", ASSAY_SYMMETRIC_TENSOR, ASSAY_ROLE_PLAIN, "Cauchy stress at the beginning of the step"}};

  void initial_state(const Tensor& cauchy, double* six) const { put_symmetric(cauchy, six); }

  /// f = F1 F0^-1 = r u; sigma1 = r (sigma0 + lambda tr(ln u) I + 2 mu ln u) r^T: second order in the step, and exactly
  /// objective, because r and u turn with the frame.
  template <class S>
  TensorOf<S> update(const IncrementOf<S>& step, const double* state0, S* state1) const {
    const auto [r, strain] = RotatedStep<S>(step);
    const TensorOf<S> turned = symmetric_from(state0).template cast<S>() + elastic_.hooke(strain);
    TensorOf<S> sigma = push_forward(r, turned);
    put_symmetric(sigma, state1);
    return sigma;
  }

  void rate(double, const Tensor&, const Tensor& l, const Tensor& cauchy, const double*, Tensor& cauchy_rate,
            double* state_rate) const {
    const Tensor d = symmetric(l), w = l - d;
    cauchy_rate = w * cauchy - cauchy * w + elastic_.hooke(d);
    put_symmetric(cauchy_rate, state_rate);
  }

  /// Functions of eps alone, because d and w are fixed tensors times d eps/dt. Simple shear from rest, gamma = 2 eps:
  /// sigma12 = mu sin gamma, sigma11 = -sigma22 = mu (cos gamma - 1).
  bool closed_form(int baseline, double eps, Tensor& tau, Tensor& slope) const {
    if (uniaxial_tau(elastic_, baseline, eps, tau, slope)) return true;
    if (baseline != ASSAY_BASELINE_SIMPLE_SHEAR) return false;
    const double mu = elastic_.mu, c = std::cos(2 * eps), s = std::sin(2 * eps), half = std::sin(eps);
    shear_tau({-2 * mu * half * half, mu * s}, {-2 * mu * s, 2 * mu * c}, eps, tau, slope);
    return true;
  }
};

}  // namespace assay::models

ASSAY_MODEL(assay::models::HypoelasticJaumann, hypoelastic_jaumann)
