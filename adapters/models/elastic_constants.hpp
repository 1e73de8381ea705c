// SPDX-License-Identifier: BSD-3-Clause
// Isotropic elastic constants, and the two parameters that most models of this folder share.
#pragma once

#include <cmath>
#include <limits>

#include "adapters/models/tensor_functions.hpp"
#include "harness/assay_material.h"

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
};

}  // namespace assay::models
