// SPDX-License-Identifier: BSD-3-Clause
// The equations of zener.
#pragma once

#include "tests/adapters/models/reference_integration.hpp"

namespace assay::model_tests {

/// S = mu (I - C^-1) + lambda ln J C^-1 + S_v, dS_v/dt = -S_v/time + ratio mu d/dt(I - C^-1), from rest.
inline Tensor zener_stress(const History& history, const Lame& elastic, double ratio, double time) {
  Values y(9, 0.0);
  const Equations equations = [&](const Values& now, Values& rate, double t) {
    const Tensor F = history.F(t), F_rate = history.F_rate(t), C_inverse = (F.transpose() * F).inverse();
    const Tensor C_rate = F_rate.transpose() * F + F.transpose() * F_rate;
    nine(-tensor_of(now.data()) / time + ratio * elastic.mu * C_inverse * C_rate * C_inverse, rate.data());
  };
  integrate_in_pieces(equations, y, 0, history.end, 60);
  const Tensor F = history.F(history.end), C_inverse = (F.transpose() * F).inverse();
  const double J = F.determinant();
  const Tensor S =
      elastic.mu * (Tensor::Identity() - C_inverse) + elastic.lambda * std::log(J) * C_inverse + tensor_of(y.data());
  return F * S * F.transpose() / J;
}

}  // namespace assay::model_tests
