// SPDX-License-Identifier: BSD-3-Clause
// The equations of j2_jaumann.
#pragma once

#include "tests/adapters/models/j2_hardening_reference.hpp"
#include "tests/adapters/models/reference_integration.hpp"

namespace assay::model_tests::j2_jaumann {

inline Lame elastic_of(const Hardening& h) { return {h.E, h.nu}; }

/// y: Cauchy stress, back stress, p.
struct Result {
  Tensor stress, back;
  double p;
};

inline double plastic_rate(const Hardening& h, const Tensor& stress, const Tensor& back, double p, const Tensor& d) {
  const Tensor from = deviator_of(stress) - back, n = from / from.norm();
  return 2 * elastic_of(h).mu * n.cwiseProduct(d).sum() / (2 * elastic_of(h).mu + 2.0 / 3 * h.kinematic + h.slope(p));
}

inline Equations equations_of(const Hardening& h, const History& history, bool plastic) {
  return [=](const Values& y, Values& rate, double t) {
    const Tensor l = velocity_gradient(history, t), d = symmetric_part(l), w = l - d;
    const Tensor stress = tensor_of(&y[0]), back = tensor_of(&y[9]), from = deviator_of(stress) - back;
    const double amount = plastic ? plastic_rate(h, stress, back, y[18], d) : 0;
    const Tensor flow = plastic ? Tensor(amount * from / from.norm()) : Tensor(Tensor::Zero());
    nine(w * stress - stress * w + elastic_of(h)(d) - 2 * elastic_of(h).mu * flow, &rate[0]);
    nine(w * back - back * w + 2.0 / 3 * h.kinematic * flow, &rate[9]);
    rate[18] = std::sqrt(2.0 / 3) * amount;
  };
}

inline Result integrated(const Hardening& h, const History& history, int slices = 200) {
  Values y(19, 0.0);
  const auto wants_plastic = [&](const Values& z, double t, bool plastic) {
    const Tensor stress = tensor_of(&z[0]), back = tensor_of(&z[9]);
    if (!plastic) return (deviator_of(stress) - back).norm() - h.radius(z[18]);
    return plastic_rate(h, stress, back, z[18], symmetric_part(velocity_gradient(history, t)));
  };
  integrate(Switching{equations_of(h, history, false), equations_of(h, history, true), wants_plastic}, y, 0,
            history.end, slices);
  return {tensor_of(&y[0]), tensor_of(&y[9]), y[18]};
}

}  // namespace assay::model_tests::j2_jaumann
