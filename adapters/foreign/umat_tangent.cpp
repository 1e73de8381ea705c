// SPDX-License-Identifier: BSD-3-Clause
// From DDSDDE to d sigma / d F1.
#include <algorithm>

#include "adapters/foreign/component_order.hpp"
#include "adapters/foreign/kinematics.hpp"
#include "adapters/foreign/umat.hpp"

namespace assay::adapters {

namespace {

/// DDSDDE, column by column, on a strain.
Tensor moduli_on(const double* ddsdde, std::size_t n, const Tensor& strain) {
  double e[6], s[6] = {};
  write_symmetric(strain, standard_order, engineering_shear, e);
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = 0; i < n; ++i) s[i] += ddsdde[j * n + i] * e[j];
  }
  return read_symmetric(s, standard_order, plain_shear);
}

Tensor unit(int component_index) {
  Tensor E = Tensor::Zero();
  component(E, component_index) = 1;
  return E;
}

}  // namespace

void Umat::tangent(const PointStep& step, double* tangent) {
  hand_over(step);
  call(step.number, step.t);
  const Tensor sigma = stress();
  const auto n = static_cast<std::size_t>(ntens_);
  const auto moduli = [&](const Tensor& strain) {
    return Tensor(model_.units.stress * moduli_on(arrays_[ddsdde_], n, strain));
  };
  const Tensor R = step_strain(step.F0, step.F1, model_.kinematics).rotation;
  for (int column = 0; column < 9; ++column) {
    const Tensor E = unit(column);
    Tensor d;
    if (model_.finite_strain) {  // (1/J) (J sigma)^Jaumann = C : D
      const Tensor l = E * step.F1.inverse(), D = 0.5 * (l + l.transpose()), w = 0.5 * (l - l.transpose());
      d = moduli(D) - D.trace() * sigma + w * sigma - sigma * w;
    } else {  // d sigma / d DSTRAN in axes that turn with DROT
      const StepStrain rate = rate_of_step(step.F0, step.F1, E, model_.kinematics);
      const Tensor w = rate.rotation * R.transpose();
      d = moduli(R * rate.strain * R.transpose()) + w * sigma - sigma * w;
    }
    for (int row = 0; row < 9; ++row) tangent[9 * row + column] = component(d, row);
  }
}

}  // namespace assay::adapters
