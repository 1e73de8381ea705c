// SPDX-License-Identifier: BSD-3-Clause
// Perzyna's viscoplasticity at finite strain: dp/dt = reference_rate <(sigma_eq - yield) / reference_stress>^exponent,
// yield = yield_stress + hardening_modulus p.
#include "adapters/models/viscoplastic.hpp"

namespace assay::models {

class Perzyna : public PowerLawFlow<true> {
 public:
  static constexpr const char* name = "perzyna";
  static constexpr const char* doc =
      "Perzyna viscoplasticity with threshold, multiplicative, logarithmic elastic strain";
  static constexpr std::uint32_t flags = ASSAY_RATE_DEPENDENT | ASSAY_USES_INCREMENT | ASSAY_NON_SMOOTH;
  static constexpr assay_parameter parameters[] = {
      youngs_modulus,
      poissons_ratio,
      {"yield_stress", "Pa", required, tiny, huge, "threshold of the equivalent stress"},
      {"hardening_modulus", "Pa", 0, 0, huge, "growth of the threshold with p"},
      reference_rate,
      reference_stress,
      rate_exponent};
  static constexpr double example[] = {1e3, 0.3, 20, 30, 0.5, 30, 3};
  static constexpr assay_state_variable state[] = {inverse_plastic_metric, viscoplastic_strain, flow_regime};

  explicit Perzyna(const double* p) : Perzyna(p, unit_of_stress(p[0])) {}

 private:
  Perzyna(const double* p, double u) : PowerLawFlow{{p[0] / u, p[1]}, p[4], p[5] / u, p[6], p[2] / u, p[3] / u, u} {}
};

}  // namespace assay::models

ASSAY_MODEL(assay::models::Perzyna, perzyna)
