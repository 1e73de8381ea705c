// SPDX-License-Identifier: BSD-3-Clause
// d cauchy / d F1 of a UMAT, from its DDSDDE.
#include "adapters/foreign/foreign_state.hpp"
#include "adapters/foreign/membrane.hpp"
#include "adapters/foreign/umat.hpp"

namespace assay::adapters {

/// DDSDDE, column by column, on a strain in the axes of space [Pa].
Tensor Umat::moduli_on(const Tensor& strain) const {
  return model_.units.stress * moduli_in_frame(arrays_[ddsdde_], components_, increment_.frame, strain);
}

Tensor Umat::finite_strain_rate(const PointStep& step, const Tensor& E, const Tensor& sigma) const {
  return stress_rate_by_moduli(step, E, sigma, model_.moduli,
                               [this](const Tensor& strain) { return moduli_on(strain); });
}

/// d sigma / d DSTRAN in axes that turn with DROT, or with R.
Tensor Umat::small_strain_rate(const PointStep& step, const Tensor& E, const Tensor& sigma) const {
  return stress_rate_of_step(step, E, sigma, model_, increment_,
                             [this](const Tensor& strain) { return moduli_on(strain); });
}

void Umat::tangent(const PointStep& given, double* tangent) {
  const PointStep step = of_model(given);
  call(step);
  const Tensor sigma = turned(stress(), increment_.frame);
  for (int column = 0; column < 9; ++column) {
    Tensor E = Tensor::Zero();
    component(E, column) = 1;
    const Tensor of_given = E;
    if (is_plane_stress()) E = rate_with_thickness(model_, step.F1, E);
    Tensor d = model_.finite_strain ? finite_strain_rate(step, E, sigma) : small_strain_rate(step, E, sigma);
    if (is_plane_stress())
      d = membrane_factor(model_, given.F1) * (d + membrane_factor_rate(model_, given.F1, of_given) * sigma);
    for (int row = 0; row < 9; ++row) tangent[9 * row + column] = component(d, row);
  }
}

}  // namespace assay::adapters
