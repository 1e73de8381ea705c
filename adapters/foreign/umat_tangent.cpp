// SPDX-License-Identifier: BSD-3-Clause
// d cauchy / d F1 of a UMAT, from its DDSDDE.
#include "adapters/foreign/foreign_state.hpp"
#include "adapters/foreign/increment_bridge.hpp"
#include "adapters/foreign/membrane.hpp"
#include "adapters/foreign/umat.hpp"

namespace assay::adapters {

/// DDSDDE, column by column, on a strain in the axes of space [Pa].
Tensor Umat::moduli_on(const Tensor& strain) const {
  const double* ddsdde = arrays_[ddsdde_];
  const auto n = static_cast<std::size_t>(ntens_);
  double e[6], s[6] = {};
  write_symmetric(Tensor(frame_.transpose() * strain * frame_), standard_order, engineering_shear, e);
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = 0; i < n; ++i) s[place(i)] += ddsdde[j * n + i] * e[place(j)];
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
  return stress_rate_of_step(step, E, sigma, model_.kinematics, turns(), turns() ? frame_ : rotation_,
                             [this](const Tensor& strain) { return moduli_on(strain); });
}

void Umat::tangent(const PointStep& given, double* tangent) {
  const PointStep step = of_model(given);
  call(step);
  const Tensor sigma = frame_ * stress() * frame_.transpose();
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
