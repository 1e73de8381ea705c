// SPDX-License-Identifier: BSD-3-Clause
// What the J2 models share: the yield surface |s - back stress| = sqrt(2/3) (yield_stress + hardening_modulus p +
// saturation_stress (1 - exp(-saturation_rate p))), the flow amount Lam with dp = sqrt(2/3) Lam, Prager's back stress
// that grows by (2/3) kinematic_modulus Lam n.
#pragma once

#include <cmath>

#include "adapters/models/elastic_constants.hpp"
#include "adapters/models/plugin.hpp"

namespace assay::models {

inline constexpr assay_parameter yield_stress{"yield_stress", "Pa", required,
                                              tiny,           huge, "initial uniaxial yield stress"};
inline constexpr assay_parameter hardening_modulus{"hardening_modulus", "Pa", 0, 0, huge, "slope of linear hardening"};
inline constexpr assay_parameter saturation_stress{
    "saturation_stress", "Pa", 0, 0, huge, "Voce hardening: final increase of the yield stress"};
inline constexpr assay_parameter saturation_rate{
    "saturation_rate", "1", 0, 0, huge, "Voce hardening: rate per equivalent plastic strain"};
inline constexpr assay_parameter kinematic_modulus{
    "kinematic_modulus", "Pa", 0, 0, huge, "Prager's linear kinematic hardening: uniaxial slope of the back stress"};

inline constexpr assay_parameter j2_parameters[] = {youngs_modulus,    poissons_ratio,    yield_stress,
                                                    hardening_modulus, saturation_stress, saturation_rate,
                                                    kinematic_modulus};
inline constexpr double j2_example[] = {1e3, 0.3, 20, 30, 15, 12, 80};

inline constexpr double root_two_thirds = 0.81649658092772603273;

/// Weight of the start in the mean normal n ~ weight start + trial (weight 1: Rice and Tracey 1973, the midpoint rule).
/// A step well beyond the size of the yield surface leans to the trial (radial return), or an error of direction would
/// swing from side to side undamped.
template <class S>
S weight_of_start(const S& trial, const S& radius) {
  return value_of(trial) > 2 * value_of(radius) ? S(2 * radius / trial) : S(1);
}

/// In the unit of stress, as all stresses here.
struct J2Hardening {
  double yield, linear, saturation, rate, kinematic;

  /// From five parameters in the order above [Pa], [1].
  J2Hardening(const double* p, double unit)
      : yield(p[0] / unit), linear(p[1] / unit), saturation(p[2] / unit), rate(p[3]), kinematic(p[4] / unit) {}

  void require_strength(double mu) const {
    if (!(yield + linear + saturation * rate + kinematic >= least_strength * mu))
      throw Failure{"yield_stress must be at least 1e-8 of the shear modulus where nothing hardens"};
  }

  /// Radius of the yield surface at the equivalent plastic strain p.
  template <class S>
  S radius(const S& p) const {
    using std::exp;
    const S fallen = exp(S(-rate * p));
    return root_two_thirds * (yield + linear * p + saturation * (1 - fallen));
  }

  /// Beyond the yield surface by less than this is on it: a step that rests on the surface, or rotates there,
  /// stays elastic and leaves the plastic strain alone bit for bit. The second term is rounding of strains, in stress,
  /// the third that of a deviator beside a large pressure.
  double tolerance(double p, double mu, double pressure = 0) const {
    return 1e-12 * radius(p) + 2e-14 * mu + 4e-15 * std::fabs(pressure);
  }

  /// d radius / d Lam = (2/3) d(yield stress)/dp.
  double slope(double p) const { return 2.0 / 3 * (linear + saturation * rate * std::exp(-rate * p)); }

  /// Growth of the back stress with Lam.
  double back() const { return 2.0 / 3 * kinematic; }

  /// A model of this kind starts inside its yield surface: Failure where the stress `cauchy` lies beyond.
  void require_below_yield(const Tensor& cauchy, double mu) const {
    if (norm(deviator(cauchy)) > radius(0.0) + tolerance(0, mu)) throw Failure{"initial stress beyond yield"};
  }
};

}  // namespace assay::models
