// SPDX-License-Identifier: BSD-3-Clause
// The equations of norton and perzyna: b_e-dot = l b_e + b_e l^T - 2 Lam n b_e.
#pragma once

#include "tests/adapters/models/reference_integration.hpp"

namespace assay::model_tests {

struct Viscoplasticity {
  double E = 1000, nu = 0.3, yield_stress = 0, hardening = 0, rate = 0.5, stress = 60, exponent = 4;
  double mu() const { return E / (2 * (1 + nu)); }
  double kappa() const { return E / (3 * (1 - 2 * nu)); }
};

/// y: b_e row-major, then p.
inline Tensor kirchhoff(const Viscoplasticity& c, const Tensor& be, double J) {
  return c.kappa() * std::log(J) * Tensor::Identity() + 2 * c.mu() * deviator_of(0.5 * log_of(be));
}

/// sigma_eq - yield_stress - hardening p [Pa].
inline double overstress(const Viscoplasticity& c, const History& history, const Values& y, double t) {
  const Tensor s = deviator_of(kirchhoff(c, tensor_of(y.data()), history.F(t).determinant()));
  return std::sqrt(1.5) * s.norm() - c.yield_stress - c.hardening * y[9];
}

inline Equations viscoplastic_equations(const Viscoplasticity& c, const History& history, bool flows) {
  return [=, &history](const Values& now, Values& rate, double t) {
    const Tensor be = tensor_of(now.data()), l = velocity_gradient(history, t);
    const double f = flows ? overstress(c, history, now, t) : 0;
    Tensor be_rate = l * be + be * l.transpose();
    rate[9] = f > 0 ? c.rate * std::pow(f / c.stress, c.exponent) : 0.0;
    if (rate[9] > 0) {
      const Tensor s = deviator_of(kirchhoff(c, be, history.F(t).determinant()));
      be_rate -= 2 * std::sqrt(1.5) * rate[9] * (s / s.norm()) * be;
    }
    nine(be_rate, rate.data());
  };
}

/// State: p. With a threshold its crossings are found: an integrator's step would not see the kink of the equations.
inline Point viscoplastic_point(const Viscoplasticity& c, const History& history, int pieces = 400) {
  Values y(10, 0.0);
  y[0] = y[4] = y[8] = 1;
  const Equations flowing = viscoplastic_equations(c, history, true);
  if (c.yield_stress > 0) {
    const auto flows = [&](const Values& z, double t, bool) { return overstress(c, history, z, t); };
    integrate(Switching{viscoplastic_equations(c, history, false), flowing, flows}, y, 0, history.end, pieces);
  } else {
    integrate_by_extrapolation(flowing, y, 0, history.end, pieces);
  }
  const double J = history.F(history.end).determinant();
  return {kirchhoff(c, tensor_of(y.data()), J) / J, {y[9]}};
}

}  // namespace assay::model_tests
