// SPDX-License-Identifier: BSD-3-Clause
// Compressible Newtonian fluid: sigma = -p I + 2 viscosity dev(d) + bulk_viscosity tr(d) I with the pressure of Tait
// and Murnaghan, p = (bulk_modulus / exponent) (J^-exponent - 1); exponent 1 is p = bulk_modulus (rho / rho0 - 1).
#include "adapters/models/elastic_constants.hpp"

namespace assay::models {

class CompressibleFluid {
 public:
  static constexpr const char* name = "compressible_fluid";
  static constexpr const char* doc = "compressible Newtonian fluid, p = (bulk_modulus / exponent) (J^-exponent - 1)";
  static constexpr std::uint32_t flags = ASSAY_RATE_DEPENDENT | ASSAY_USES_INCREMENT;
  static constexpr assay_parameter parameters[] = {
      {"bulk_modulus", "Pa", required, tiny, huge, "bulk modulus at the reference density"},
      {"viscosity", "Pa s", 0, 0, huge, "shear viscosity"},
      {"bulk_viscosity", "Pa s", 0, 0, huge, "volume viscosity"},
      {"exponent", "1", 1, 1, 100, "exponent of the pressure law; 7 for water (Tait)"}};
  static constexpr double example[] = {500, 3, 2, 7};

  explicit CompressibleFluid(const double* p) : modulus_(p[0]), shear_(p[1]), bulk_(p[2]), exponent_(p[3]) {}

  /// f = F1 F0^-1 = r u, d = r ln(u) r^T / dt: exactly objective, and d at the end of the step to first order.
  template <class S>
  TensorOf<S> update(const IncrementOf<S>& step, const double*, S*) const {
    TensorOf<S> sigma = TensorOf<S>::Zero();
    S mean = -pressure(determinant(step.F1));
    if (shear_ > 0 || bulk_ > 0) {
      const TensorOf<S> f = step.F1 * inverse(step.F0).template cast<S>();
      const TensorOf<S> d = S(0.5 / step.dt) * logarithm(left_cauchy_green(f));  // ln(v) / dt
      sigma = S(2 * shear_) * deviator(d);
      mean += S(bulk_) * trace(d);
    }
    for (int i = 0; i < 3; ++i) sigma(i, i) += mean;
    return sigma;
  }

  /// The stored part: p = -dW/dJ.
  double energy(const Tensor& F, const double*) const {
    const double J = determinant(F), g = exponent_;
    if (g == 1) return modulus_ * (J - 1 - std::log(J));
    return modulus_ / g * ((std::pow(J, 1 - g) - 1) / (g - 1) + J - 1);
  }

  /// Of sound: c^2 = dp/drho = bulk_modulus J^(1-exponent) / rho0.
  double wave_speed(double density, const Tensor& F, const Tensor&, const double*) const {
    return std::sqrt(modulus_ * std::pow(determinant(F), 1 - exponent_) / density);
  }

  /// Without viscosity: no stress in simple shear; P11 = -p, P22 = P33 = -p J in uniaxial strain.
  bool closed_form(int baseline, double eps, Tensor& tau, Tensor& dtau_deps) const {
    if (shear_ > 0 || bulk_ > 0) return false;
    if (baseline == ASSAY_BASELINE_SIMPLE_SHEAR) return true;
    const double s = 1 + eps;
    if (baseline != ASSAY_BASELINE_UNIAXIAL_STRAIN || !(s > 0)) return false;
    const double p = pressure(s), p_slope = -modulus_ * std::pow(s, -exponent_ - 1);
    tau(0, 0) = -p;
    tau(1, 1) = tau(2, 2) = -p * s;
    dtau_deps(0, 0) = -p_slope;
    dtau_deps(1, 1) = dtau_deps(2, 2) = -(p + p_slope * s);
    return true;
  }

 private:
  template <class S>
  S pressure(const S& J) const {
    using std::pow;
    if (exponent_ == 1) return S(modulus_) * (S(1) / J - S(1));
    return S(modulus_ / exponent_) * (pow(J, -exponent_) - S(1));
  }

  double modulus_, shear_, bulk_, exponent_;
};

}  // namespace assay::models

ASSAY_MODEL(assay::models::CompressibleFluid, compressible_fluid)
