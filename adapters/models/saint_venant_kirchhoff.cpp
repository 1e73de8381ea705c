// SPDX-License-Identifier: BSD-3-Clause
// Saint Venant-Kirchhoff elasticity: S = lambda tr(E) I + 2 mu E, W = lambda/2 tr(E)^2 + mu E:E (Ciarlet 1988, 3.9).
#include "adapters/models/baselines.hpp"

namespace assay::models {

class SaintVenantKirchhoff : public ElasticModel {
 public:
  using ElasticModel::ElasticModel;
  static constexpr const char* name = "saint_venant_kirchhoff";
  static constexpr const char* doc = "Saint Venant-Kirchhoff elasticity, S = lambda tr(E) I + 2 mu E";

  template <class S>
  TensorOf<S> update(const IncrementOf<S>& step, const double*, S*) const {
    return cauchy_of(step.F1, elastic_.hooke(green_strain(step.F1)));
  }

  double energy(const Tensor& F, const double*) const {
    const Tensor E = green_strain(F);
    const double volume = trace(E);
    return 0.5 * elastic_.lambda * volume * volume + elastic_.mu * contraction(E, E);
  }

  /// P11 = (lambda + 2 mu) gamma^2 / 2, P12 = mu gamma, ... as P = F S.
  bool closed_form(int baseline, double eps, Tensor& tau, Tensor& dtau_deps) const {
    const double along = elastic_.lambda + 2 * elastic_.mu;
    return green_strain_baseline(along, elastic_.lambda, elastic_.lambda, elastic_.mu, baseline, eps, tau, dtau_deps);
  }
};

}  // namespace assay::models

ASSAY_MODEL(assay::models::SaintVenantKirchhoff, saint_venant_kirchhoff)
