// SPDX-License-Identifier: BSD-3-Clause
// What every model must satisfy, as measured errors: functions of a material alone, so that a planted bug can be
// measured too. Relative to the largest component of what is compared, unless said otherwise; 0 where the model does
// not offer what is measured.
#pragma once

#include "tests/adapters/models/histories.hpp"

namespace assay::model_tests {

/// Increments, rates and energies: `visited` counts the states that were compared.
struct Measured {
  double error = 0;
  int visited = 0;
  void add(double e) { error = std::isfinite(e) ? std::max(error, e) : INFINITY, ++visited; }
};

/// `assay.rate/1` against forward differences of the increments, extrapolated; state rates included.
Measured rate_error(const Material& material);

/// `assay.tangent/1` against central differences of `update`.
Measured tangent_error(const Material& material);

/// Cauchy stress seen from a turning frame, turned back, against the stress of a frame at rest: rotation about (1, 2,
/// 3) before, during and after loading.
Measured objectivity_error(const Material& material);

/// First Piola-Kirchhoff stress against dW/dF by differences.
Measured energy_error(const Material& material);

/// 1 where a repeated call, or the same point in a batch, differs in any bit.
Measured impurity(const Material& material);

/// `assay.closed_form/1` against extrapolated increments.
Measured closed_form_error(const Material& material);

/// Its slope against differences of itself.
Measured closed_form_slope_error(const Material& material);

/// Stress at F = I, relative to that of a sheared point.
Measured rest_error(const Material& material);

/// Of a non-smooth model, 1 where an elastic step changes a scalar of the state, or a step that is not leaves all
/// alone.
Measured regime_error(const Material& material);

}  // namespace assay::model_tests
