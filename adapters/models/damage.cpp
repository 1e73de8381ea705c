// SPDX-License-Identifier: BSD-3-Clause
// Isotropic damage with softening after Simo (1987): sigma = (1 - D) sigma_0, sigma_0 the neo-Hookean stress (34) of
// the undamaged material, D = D_max (1 - exp(-(kappa - kappa_0) / kappa_f)), kappa the largest energy W_0 so far.
#include "adapters/models/elastic_constants.hpp"

namespace assay::models {

class Damage {
 public:
  static constexpr const char* name = "damage";
  static constexpr const char* doc = "neo-Hookean elasticity (34) with isotropic damage and softening";
  static constexpr std::uint32_t flags = ASSAY_NON_SMOOTH;
  static constexpr assay_parameter parameters[] = {
      youngs_modulus,
      poissons_ratio,
      {"kappa_0", "J/m^3", required, 0, huge, "energy W_0 at which damage begins"},
      {"kappa_f", "J/m^3", required, tiny, huge, "energy scale, beyond kappa_0, over which damage grows"},
      {"D_max", "1", 0.99, 0, 0.999999, "limit of the damage, below 1"}};
  static constexpr double example[] = {1e3, 0.3, 0.5, 20, 0.99};
  static constexpr assay_state_variable state[] = {
      {"kappa", "J/m^3", ASSAY_SCALAR, ASSAY_ROLE_PLAIN, "largest energy W_0 so far, at least kappa_0"}};

  explicit Damage(const double* p) : elastic_(p[0], p[1]), threshold_(p[2]), scale_(p[3]), most_(p[4]) {}

  void initial_state(const Tensor& cauchy, double* kappa) const {
    require_stress_free(cauchy);
    *kappa = threshold_;
  }

  /// Exact for a step along which W_0 grows all the way, or stays below kappa.
  template <class S>
  TensorOf<S> update(const IncrementOf<S>& step, const double* state0, S* state1) const {
    const S W = undamaged_energy(step.F1);
    if (value_of(W) > state0[0]) state1[0] = W;
    return integrity(state1[0]) * undamaged_stress(step.F1);
  }

  /// kappa follows W_0 where it is at its largest (to 1e-9) and grows: dW_0/dt = J sigma_0 : d. What an integrator
  /// drifts from W_0 decays with the strain, so that it does not switch at every step.
  void rate(double, const Tensor& F, const Tensor& l, const Tensor&, const double* at, Tensor& cauchy_rate,
            double* state_rate) const {
    const double W = undamaged_energy(F);
    const double power = determinant(F) * contraction(undamaged_stress(F), symmetric(l));
    const bool loading = W >= at[0] - on_surface * (at[0] + scale_) && power > 0;
    state_rate[0] = loading ? power + symmetric(l).norm() * (W - at[0]) : 0.0;
    const auto stress = [this](const auto& moving) { return undamaged_stress(moving); };
    cauchy_rate = integrity(at[0]) * derivative_along(stress, F, Tensor(l * F)) +
                  integrity_slope(at[0]) * state_rate[0] * undamaged_stress(F);
  }

  /// W = (1 - D) W_0.
  double energy(const Tensor& F, const double* at) const { return integrity(at[0]) * undamaged_energy(F); }

 private:
  static constexpr double on_surface = 1e-9;

  /// W_0 of (34) [J/m^3].
  template <class S>
  S undamaged_energy(const TensorOf<S>& F) const {
    using std::log;
    const S ln_J = log(determinant(F));
    return S(0.5 * elastic_.lambda) * ln_J * ln_J - S(elastic_.mu) * ln_J +
           S(0.5 * elastic_.mu) * (contraction(F, F) - S(3));
  }

  /// (34) [Pa].
  template <class S>
  TensorOf<S> undamaged_stress(const TensorOf<S>& F) const {
    using std::log;
    const S J = determinant(F), shear = S(elastic_.mu) / J, pressure = S(elastic_.lambda) * log(J) / J - shear;
    TensorOf<S> sigma = shear * left_cauchy_green(F);
    for (int i = 0; i < 3; ++i) sigma(i, i) += pressure;
    return sigma;
  }

  /// 1 - D.
  template <class S>
  S integrity(const S& kappa) const {
    using std::exp;
    if (value_of(kappa) <= threshold_) return S(1);
    return S(1 - most_) + S(most_) * S(exp((S(threshold_) - kappa) * S(1 / scale_)));
  }

  /// d(1 - D) / d kappa where damage grows.
  double integrity_slope(double kappa) const { return -most_ / scale_ * std::exp((threshold_ - kappa) / scale_); }

  ElasticConstants elastic_;
  double threshold_, scale_, most_;
};

}  // namespace assay::models

ASSAY_MODEL(assay::models::Damage, damage)
