// SPDX-License-Identifier: BSD-3-Clause
// Norton's viscoplasticity at finite strain: dp/dt = reference_rate (sigma_eq / reference_stress)^exponent, no
// threshold.
#include "adapters/models/viscoplastic.hpp"

namespace assay::models {

class Norton : public PowerLawFlow<false> {
 public:
  static constexpr const char* name = "norton";
  static constexpr const char* doc =
      "Norton viscoplasticity without threshold, multiplicative, logarithmic elastic strain";
  static constexpr std::uint32_t flags = ASSAY_RATE_DEPENDENT | ASSAY_USES_INCREMENT;
  static constexpr assay_parameter parameters[] = {youngs_modulus, poissons_ratio, reference_rate, reference_stress,
                                                   rate_exponent};
  static constexpr double example[] = {1e3, 0.3, 0.5, 30, 3};
  static constexpr assay_state_variable state[] = {inverse_plastic_metric, viscoplastic_strain};

  explicit Norton(const double* p) : Norton(p, unit_of_stress(p[0])) {}

 private:
  Norton(const double* p, double u) : PowerLawFlow{{p[0] / u, p[1]}, p[2], p[3] / u, p[4], 0, 0, u} {}
};

}  // namespace assay::models

ASSAY_MODEL(assay::models::Norton, norton)
