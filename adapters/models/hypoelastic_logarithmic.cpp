// SPDX-License-Identifier: BSD-3-Clause
// Hypoelasticity with the logarithmic rate of the Cauchy stress, dsigma/dt - Omega sigma + sigma Omega = lambda tr(d) I
// + 2 mu d. The logarithmic rate of ln V is d (Xiao, Bruhns and Meyers 1997), so from rest it integrates exactly to
// sigma = lambda tr(ln V) I + 2 mu ln V, F = V R: no state, no increment.
#include "adapters/models/baselines.hpp"

namespace assay::models {

class HypoelasticLogarithmic : public ElasticModel {
 public:
  using ElasticModel::ElasticModel;
  static constexpr const char* name = "hypoelastic_logarithmic";
  static constexpr const char* doc = "hypoelasticity, logarithmic rate of the Cauchy stress";

  template <class S>
  TensorOf<S> update(const IncrementOf<S>& step, const double*, S*) const {
    return stress(step.F1);
  }

  /// The derivative of the stress along Fdot = l F.
  void rate(double, const Tensor& F, const Tensor& l, const Tensor&, const double*, Tensor& cauchy_rate,
            double*) const {
    cauchy_rate = derivative_along([&](const auto& moving) { return stress(moving); }, F, Tensor(l * F));
  }

  /// Simple shear, gamma = 2 eps: ln V = asinh(eps) / sqrt(1 + eps^2) [[-eps, 1], [1, eps]].
  bool closed_form(int baseline, double eps, Tensor& tau, Tensor& slope) const {
    if (uniaxial_tau(elastic_, baseline, eps, tau, slope)) return true;
    if (baseline != ASSAY_BASELINE_SIMPLE_SHEAR) return false;
    const double twice = 2 * elastic_.mu, square = 1 + eps * eps;
    const double q = std::asinh(eps) / std::sqrt(square), dq = (1 - eps * q) / square;
    shear_tau({-twice * q * eps, twice * q}, {-twice * (dq * eps + q), twice * dq}, eps, tau, slope);
    return true;
  }

 private:
  template <class S>
  TensorOf<S> stress(const TensorOf<S>& F) const {
    return elastic_.hooke(TensorOf<S>(S(0.5) * logarithm(left_cauchy_green(F))));
  }
};

}  // namespace assay::models

ASSAY_MODEL(assay::models::HypoelasticLogarithmic, hypoelastic_logarithmic)
