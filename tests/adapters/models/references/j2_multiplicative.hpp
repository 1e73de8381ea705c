// SPDX-License-Identifier: BSD-3-Clause
// The equations of j2_multiplicative.
#pragma once

#include "harness/numeric/central_difference.hpp"
#include "tests/adapters/models/j2_hardening_reference.hpp"
#include "tests/adapters/models/reference_integration.hpp"

namespace assay::model_tests::j2_multiplicative {

inline Lame elastic_of(const Hardening& h) { return {h.E, h.nu}; }

/// dev tau - beta, and its direction.
struct Surface {
  Tensor from, n, V;
};

inline Tensor rotation_by_eigenvectors(const Tensor& F) { return F * root_of(F.transpose() * F).inverse(); }

/// y: b_e, unrotated back stress A, p.
inline Surface surface_of(const Hardening& h, const Values& y, const Tensor& R) {
  const Tensor b = tensor_of(&y[0]), back = R * tensor_of(&y[9]) * R.transpose();
  const Tensor from = elastic_of(h).mu * deviator_of(log_of(b)) - back;
  return {from, from / from.norm(), root_of(b)};
}

/// Rate of |dev tau - beta| - radius for a rate of b_e and no other change; the norm by a difference of 8th order.
inline double norm_rate(const Hardening& hardening, const Values& y, const Tensor& R, const Tensor& b_rate) {
  const auto size = [&](double h) {
    Values z = y;
    nine(tensor_of(&y[0]) + h * b_rate, z.data());
    return surface_of(hardening, z, R).from.norm();
  };
  const double h = 2e-3 / (1 + b_rate.norm());
  return central_difference([&](int k) { return size(k * h); }, h);
}

struct Rates {
  Tensor b, back;
  double p, amount;
};

/// db_e/dt = l b_e + b_e l^T - 2 Lam V n V, dA/dt = (2/3) kinematic_modulus Lam R^T n R, Lam from consistency.
inline Rates rates_of(const Hardening& h, const History& history, const Values& y, double t, bool plastic) {
  const Tensor F = history.F(t), l = velocity_gradient(history, t), b = tensor_of(&y[0]);
  const Tensor pushed = l * b + b * l.transpose();
  if (!plastic) return {pushed, Tensor::Zero(), 0, 0};
  const Tensor R = rotation_by_eigenvectors(F);
  const Surface s = surface_of(h, y, R);
  const Tensor flow = 2 * s.V * s.n * s.V;
  // The spin of the frame turns b_e and beta alike, and leaves the norm alone: without it, b_e changes by the rest.
  const double dt = 1e-4;
  Tensor spin = Tensor::Zero();
  if (h.kinematic != 0) {
    const auto R_at = [&](double x) { return rotation_by_eigenvectors(history.F(x)); };
    spin = (8 * (R_at(t + dt) - R_at(t - dt)) - (R_at(t + 2 * dt) - R_at(t - 2 * dt))) / (12 * dt) * R.transpose();
  }
  const double amount = norm_rate(h, y, R, pushed - spin * b + b * spin) /
                        (norm_rate(h, y, R, flow) + 2.0 / 3 * h.kinematic + h.slope(y[18]));
  return {pushed - amount * flow, 2.0 / 3 * h.kinematic * amount * R.transpose() * s.n * R, std::sqrt(2.0 / 3) * amount,
          amount};
}

struct Result {
  Tensor stress;
  double p;
};

inline Result integrated(const Hardening& h, const History& history, int slices = 200) {
  Values y(19, 0.0);
  nine(Tensor::Identity(), y.data());
  const auto equations = [&](bool plastic) -> Equations {
    return [&, plastic](const Values& now, Values& rate, double t) {
      const Rates r = rates_of(h, history, now, t, plastic);
      nine(r.b, &rate[0]), nine(r.back, &rate[9]);
      rate[18] = r.p;
    };
  };
  const auto wants_plastic = [&](const Values& z, double t, bool plastic) {
    if (!plastic) return surface_of(h, z, rotation_by_eigenvectors(history.F(t))).from.norm() - h.radius(z[18]);
    return rates_of(h, history, z, t, true).amount;
  };
  integrate(Switching{equations(false), equations(true), wants_plastic}, y, 0, history.end, slices);
  const Tensor e = 0.5 * log_of(tensor_of(&y[0]));
  const double J = history.F(history.end).determinant();
  return {(elastic_of(h).kappa() * std::log(J) * Tensor::Identity() + 2 * elastic_of(h).mu * deviator_of(e)) / J,
          y[18]};
}

}  // namespace assay::model_tests::j2_multiplicative
