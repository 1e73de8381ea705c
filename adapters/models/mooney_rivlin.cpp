// SPDX-License-Identifier: BSD-3-Clause
// Compressible Mooney-Rivlin elasticity, volume and shape apart:
//   W = c10 (I1bar - 3) + c01 (I2bar - 3) + kappa/2 (ln J)^2,  I1bar = J^-2/3 tr b,  I2bar = J^-4/3 (tr(b)^2 - tr
//   b^2)/2.
#include "adapters/models/elastic_constants.hpp"

namespace assay::models {

class MooneyRivlin {
 public:
  static constexpr const char* name = "mooney_rivlin";
  static constexpr const char* doc =
      "Mooney-Rivlin elasticity, W = c10 (I1bar - 3) + c01 (I2bar - 3) + bulk_modulus/2 (ln J)^2";
  static constexpr assay_parameter parameters[] = {
      {"c10", "Pa", required, tiny, huge, "coefficient of I1bar - 3; the shear modulus is 2 (c10 + c01)"},
      {"c01", "Pa", 0, 0, huge, "coefficient of I2bar - 3"},
      {"bulk_modulus", "Pa", required, tiny, huge, "bulk modulus kappa"}};
  static constexpr double example[] = {120, 40, 800};

  explicit MooneyRivlin(const double* p) : c10_(p[0]), c01_(p[1]), kappa_(p[2]) {}

  /// J sigma = kappa ln J I + 2 dev(c10 bbar + c01 (I1bar bbar - bbar^2)), bbar = J^-2/3 b.
  template <class S>
  TensorOf<S> update(const IncrementOf<S>& step, const double*, S*) const {
    using std::log;
    using std::pow;
    const S J = determinant(step.F1);
    const TensorOf<S> b = pow(J, -2.0 / 3) * left_cauchy_green(step.F1);
    const TensorOf<S> M = (S(c10_) + S(c01_) * trace(b)) * b - S(c01_) * TensorOf<S>(b * b);
    TensorOf<S> tau = S(2) * deviator(M);
    const S pressure = S(kappa_) * log(J);
    for (int i = 0; i < 3; ++i) tau(i, i) += pressure;
    return symmetric(TensorOf<S>((S(1) / J) * tau));
  }

  double energy(const Tensor& F, const double*) const {
    const double J = determinant(F), ln_J = std::log(J);
    const Tensor b = std::pow(J, -2.0 / 3) * left_cauchy_green(F);
    const double I1 = trace(b), I2 = 0.5 * (I1 * I1 - contraction(b, b));
    return c10_ * (I1 - 3) + c01_ * (I2 - 3) + 0.5 * kappa_ * ln_J * ln_J;
  }

  bool closed_form(int baseline, double eps, Tensor& tau, Tensor& dtau_deps) const {
    if (baseline == ASSAY_BASELINE_SIMPLE_SHEAR) return simple_shear(2 * eps, tau, dtau_deps);
    return baseline == ASSAY_BASELINE_UNIAXIAL_STRAIN && uniaxial_strain(1 + eps, tau, dtau_deps);
  }

 private:
  /// sigma11 = -2/3 (c10 + 2 c01) gamma^2, sigma22 = 2/3 (2 c10 + c01) gamma^2, sigma33 = 2/3 (c01 - c10) gamma^2,
  /// sigma12 = mu gamma, mu = 2 (c10 + c01); P = sigma F^-T.
  bool simple_shear(double gamma, Tensor& tau, Tensor& slope) const {
    const double a = -2.0 / 3 * (c10_ + 2 * c01_), b = 2.0 / 3 * (2 * c10_ + c01_), c = 2.0 / 3 * (c01_ - c10_);
    const double mu = 2 * (c10_ + c01_), square = gamma * gamma;
    tau(0, 0) = a * square;
    tau(0, 1) = (mu - a * square) * gamma;
    tau(1, 0) = mu * gamma;
    tau(1, 1) = (b - mu) * square;
    tau(2, 2) = c * square;
    slope(0, 0) = 4 * a * gamma;
    slope(0, 1) = 2 * (mu - 3 * a * square);
    slope(1, 0) = 2 * mu;
    slope(1, 1) = 4 * (b - mu) * gamma;
    slope(2, 2) = 4 * c * gamma;
    return true;
  }

  /// Stretch s = J: tau_K11 = kappa ln s + 4/3 d, tau_K22 = tau_K33 = kappa ln s - 2/3 d,
  /// d = c10 (s^4/3 - s^-2/3) + c01 (s^2/3 - s^-4/3); P11 = tau_K11 / s.
  bool uniaxial_strain(double s, Tensor& tau, Tensor& slope) const {
    if (!(s > 0)) return false;
    const double root = std::cbrt(s), square = root * root, volume = kappa_ * std::log(s);
    const double d = c10_ * (s * root - 1 / square) + c01_ * (square - 1 / (square * square));
    const double d_slope = (c10_ * (4 * root + 2 / (s * square)) + c01_ * (2 / root + 4 / (s * square * square))) / 3;
    const double along = volume + 4.0 / 3 * d, along_slope = kappa_ / s + 4.0 / 3 * d_slope;
    tau(0, 0) = along / s;
    tau(1, 1) = tau(2, 2) = volume - 2.0 / 3 * d;
    slope(0, 0) = (along_slope - along / s) / s;
    slope(1, 1) = slope(2, 2) = kappa_ / s - 2.0 / 3 * d_slope;
    return true;
  }

  double c10_, c01_, kappa_;
};

}  // namespace assay::models

ASSAY_MODEL(assay::models::MooneyRivlin, mooney_rivlin)
