// SPDX-License-Identifier: BSD-3-Clause
// From DDSDDE to d sigma / d F1.
#include <algorithm>

#include "adapters/foreign/foreign_state.hpp"
#include "adapters/foreign/kinematics.hpp"
#include "adapters/foreign/umat.hpp"

namespace assay::adapters {

namespace {

Tensor unit(int component_index) {
  Tensor E = Tensor::Zero();
  component(E, component_index) = 1;
  return E;
}

}  // namespace

/// DDSDDE, column by column, on a strain in the axes of space [Pa].
Tensor Umat::moduli_on(const Tensor& strain) const {
  const double* ddsdde = arrays_[ddsdde_];
  const auto n = static_cast<std::size_t>(ntens_);
  double e[6], s[6] = {};
  write_symmetric(Tensor(frame_.transpose() * strain * frame_), standard_order, engineering_shear, e);
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = 0; i < n; ++i) s[i] += ddsdde[j * n + i] * e[j];
  }
  return model_.units.stress * frame_ * read_symmetric(s, standard_order, plain_shear) * frame_.transpose();
}

/// (1/J) (J sigma)^Jaumann = C : D, in any axes; that of Truesdell has - D sigma - sigma D beside it.
Tensor Umat::finite_strain_rate(const PointStep& step, const Tensor& E, const Tensor& sigma) const {
  const Tensor l = E * step.F1.inverse(), D = 0.5 * (l + l.transpose()), w = 0.5 * (l - l.transpose());
  const bool of_tau = model_.moduli == Moduli::jaumann_of_tau || model_.moduli == Moduli::truesdell_of_tau;
  Tensor objective = moduli_on(D) / (of_tau ? step.F1.determinant() : 1);
  if (model_.moduli == Moduli::truesdell || model_.moduli == Moduli::truesdell_of_tau) {
    objective += D * sigma + sigma * D;
  }
  return objective - D.trace() * sigma + w * sigma - sigma * w;
}

/// d sigma / d DSTRAN in axes that turn with DROT, or with R.
Tensor Umat::small_strain_rate(const PointStep& step, const Tensor& E, const Tensor& sigma) const {
  const StepStrain rate = turns() ? rate_of_corotational_step(step.F0, step.F1, E, model_.kinematics)
                                  : rate_of_step(step.F0, step.F1, E, model_.kinematics);
  const Tensor& R = turns() ? frame_ : rotation_;
  const Tensor w = rate.rotation * R.transpose();
  return moduli_on(R * rate.strain * R.transpose()) + w * sigma - sigma * w;
}

void Umat::tangent(const PointStep& step, double* tangent) {
  call(step);
  const Tensor sigma = frame_ * stress() * frame_.transpose();
  for (int column = 0; column < 9; ++column) {
    const Tensor E = unit(column);
    const Tensor d = model_.finite_strain ? finite_strain_rate(step, E, sigma) : small_strain_rate(step, E, sigma);
    for (int row = 0; row < 9; ++row) tangent[9 * row + column] = component(d, row);
  }
}

}  // namespace assay::adapters
