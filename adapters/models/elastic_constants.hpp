// SPDX-License-Identifier: BSD-3-Clause
// Isotropic elastic constants, and the two parameters that most models of this folder share.
#pragma once

#include <cmath>
#include <limits>

#include "adapters/models/plugin.hpp"

namespace assay::models {

inline constexpr double required = std::numeric_limits<double>::quiet_NaN();
inline constexpr double tiny = 1e-300, huge = 1e300;  ///< bounds of what must be positive and finite

inline constexpr assay_parameter youngs_modulus{"E", "Pa", required, tiny, huge, "Young's modulus"};
inline constexpr assay_parameter poissons_ratio{"nu", "1", 0.3, -0.999999, 0.499999999, "Poisson's ratio"};

/// Of a plastic model, in shear moduli: with less, rounding of strains beside 1 makes a stress as large as its own.
inline constexpr double least_strength = 1e-8;

/// A power of two near Young's modulus [Pa], in which models count stress where they square it: the squares then
/// neither overflow nor vanish, and no bit of the result is another.
inline double unit_of_stress(double E) { return std::ldexp(1.0, std::ilogb(E)); }

struct ElasticConstants {
  double lambda, mu, kappa;  ///< Lame's constants and the bulk modulus kappa = lambda + 2 mu / 3 [Pa]

  ElasticConstants(double E, double nu)
      : lambda(E * nu / ((1 + nu) * (1 - 2 * nu))), mu(E / (2 * (1 + nu))), kappa(lambda + 2 * mu / 3) {}

  /// lambda tr(e) I + 2 mu e [Pa].
  template <class S>
  TensorOf<S> hooke(const TensorOf<S>& e) const {
    TensorOf<S> stress = S(2 * mu) * e;
    const S pressure = S(lambda) * trace(e);
    for (int i = 0; i < 3; ++i) stress(i, i) += pressure;
    return stress;
  }

  /// kappa/2 tr(e)^2 + mu dev e : dev e [J/m^3].
  double stored(const Tensor& e) const {
    const Tensor shape = deviator(e);
    return 0.5 * kappa * trace(e) * trace(e) + mu * contraction(shape, shape);
  }
};

/// What models of these two parameters alone have in common.
class ElasticModel {
 public:
  static constexpr assay_parameter parameters[] = {youngs_modulus, poissons_ratio};
  static constexpr double example[] = {1e3, 0.3};

  explicit ElasticModel(const double* p) : elastic_(p[0], p[1]) {}

 protected:
  ElasticConstants elastic_;
};

/// f = F1 F0^-1 = r u of a step: r, and ln u, which do not know a rotation of the frame.
template <class S>
struct RotatedStep {
  TensorOf<S> r, strain;

  explicit RotatedStep(const IncrementOf<S>& step) {
    const TensorOf<S> f = step.F1 * inverse(step.F0).template cast<S>();
    r = rotation_of(f);
    strain = logarithm(symmetric(TensorOf<S>(r.transpose() * f)));
  }
};

}  // namespace assay::models
