// SPDX-License-Identifier: BSD-3-Clause
// The equations of drucker_prager on its cone, between events that are found by bisection.
#pragma once

#include <gtest/gtest.h>

#include "tests/adapters/models/reference_integration.hpp"

namespace assay::model_tests::drucker_prager {

struct Cone {
  double E = 1000, nu = 0.3, cohesion = 20, friction = 0.25, dilatancy = 0.1, hardening = 30;
  double mu() const { return E / (2 * (1 + nu)); }
  double kappa() const { return E / (3 * (1 - 2 * nu)); }
};

/// tau = kappa tr(e) I + 2 mu dev e, e = ln(b_e)/2.
inline Tensor kirchhoff(const Cone& c, const Tensor& be) {
  const Tensor e = 0.5 * log_of(be);
  return c.kappa() * e.trace() * Tensor::Identity() + 2 * c.mu() * deviator_of(e);
}

inline double root_J2(const Tensor& tau) { return std::sqrt(0.5) * deviator_of(tau).norm(); }

inline double yield(const Cone& c, const Tensor& be, double p) {
  const Tensor tau = kirchhoff(c, be);
  return root_J2(tau) + c.friction * tau.trace() - c.cohesion - c.hardening * p;
}

/// b_e and p after the flow from t0 to t1, where the path loads all the way.
inline void flow(const Cone& c, const History& history, double t0, double t1, Tensor& be, double& p) {
  std::vector<double> y(10);
  for (int i = 0; i < 9; ++i) y[static_cast<std::size_t>(i)] = be(i / 3, i % 3);
  y[9] = p;
  const auto slope = [&](const std::vector<double>& now, std::vector<double>& rate, double t) {
    const Tensor b = tensor_of(now.data()), l = velocity_gradient(history, t), d = 0.5 * (l + l.transpose());
    const Tensor tau = kirchhoff(c, b), s = deviator_of(tau), I = Tensor::Identity();
    const double J2 = root_J2(tau);
    const double loading = c.mu() / J2 * s.cwiseProduct(d).sum() + 3 * c.friction * c.kappa() * d.trace();
    EXPECT_GE(loading, -1e-9);
    const double Lam = loading / (c.mu() + 9 * c.kappa() * c.friction * c.dilatancy + c.hardening / std::sqrt(3.0));
    const Tensor b_rate = l * b + b * l.transpose() - 2 * Lam * (s / (2 * J2) + c.dilatancy * I) * b;
    for (int i = 0; i < 9; ++i) rate[static_cast<std::size_t>(i)] = b_rate(i / 3, i % 3);
    rate[9] = Lam / std::sqrt(3.0);
  };
  integrate_in_pieces(slope, y, t0, t1, 100);
  be = tensor_of(y.data());
  p = y[9];
}

/// Elastic from `from` until yield, then flowing until the next of `turns`, and so on.
struct Reference {
  Tensor cauchy;
  double p = 0;
  std::vector<double> yields;
};

inline Reference reference(const Cone& c, const History& history) {
  Reference result;
  Tensor A = Tensor::Identity();
  double from = 0;
  const auto& F = history.F;
  std::vector<double> turns = history.turns;
  turns.push_back(history.end);
  for (const double turn : turns) {
    const auto f = [&](double t) { return yield(c, F(t) * A * F(t).transpose(), result.p); };
    double low = from + 1e-3, high = turn;
    while (f(low) > 0) low -= 1e-4;
    for (double t = low; t < turn; t += 0.01) {
      if (f(t) > 0) {
        high = t;
        break;
      }
      low = t;
    }
    for (int k = 0; k < 60; ++k) (f(0.5 * (low + high)) > 0 ? high : low) = 0.5 * (low + high);
    Tensor be = F(high) * A * F(high).transpose();
    flow(c, history, high, turn, be, result.p);
    const Tensor inverse = F(turn).inverse();
    A = inverse * be * inverse.transpose();
    result.cauchy = kirchhoff(c, be) / F(turn).determinant();
    result.yields.push_back(high);
    from = turn;
  }
  return result;
}

}  // namespace assay::model_tests::drucker_prager
