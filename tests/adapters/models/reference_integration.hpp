// SPDX-License-Identifier: BSD-3-Clause
// Integration of a model's differential equations that owes nothing to the model: Boost.Odeint at 1e-12, and events
// where the equations switch.
#pragma once

#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/bulirsch_stoer.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include "tests/adapters/models/histories.hpp"

namespace assay::model_tests {

using Values = std::vector<double>;
using Equations = std::function<void(const Values&, Values&, double)>;

inline void integrate(const Equations& equations, Values& y, double from, double to, int first_steps = 10) {
  namespace odeint = boost::numeric::odeint;
  if (!(to > from)) return;
  auto stepper = odeint::make_controlled<odeint::runge_kutta_fehlberg78<Values>>(1e-12, 1e-12);
  odeint::integrate_adaptive(stepper, equations, y, from, to, (to - from) / first_steps);
}

/// By Bulirsch and Stoer's extrapolation: for equations that are nearly not smooth somewhere. Fehlberg's estimate,
/// which compares two stages at the ends of a step, does not see that.
inline void integrate_by_extrapolation(const Equations& equations, Values& y, double from, double to, int pieces) {
  namespace odeint = boost::numeric::odeint;
  odeint::bulirsch_stoer<Values> stepper(1e-13, 1e-13);
  for (int k = 0; k < pieces; ++k) {
    const double begin = from + (to - from) * k / pieces, end = from + (to - from) * (k + 1) / pieces;
    odeint::integrate_adaptive(stepper, equations, y, begin, end, end - begin);
  }
}

/// Equations with two regimes. `wants_plastic(y, t, plastic)`: > 0 where the plastic regime holds from here on.
struct Switching {
  Equations elastic, plastic;
  std::function<double(const Values&, double, bool)> wants_plastic;
};

inline void integrate(const Switching& s, Values& y, double from, double to, int slices = 200) {
  bool plastic = false;
  double t = from;
  for (int i = 0; i < slices; ++i) {
    const double goal = from + (to - from) * (i + 1) / slices;
    while (t < goal) {
      const Equations& equations = plastic ? s.plastic : s.elastic;
      const auto stays = [&](double until, Values& z) {
        z = y;
        integrate(equations, z, t, until, 2);
        return (s.wants_plastic(z, until, plastic) > 0) == plastic;
      };
      Values end;
      if (stays(goal, end)) {
        y = end, t = goal;
        continue;
      }
      double low = t, high = goal;  // the switch lies between
      for (int k = 0; k < 60 && high - low > 1e-15; ++k) {
        const double middle = 0.5 * (low + high);
        (stays(middle, end) ? low : high) = middle;
      }
      stays(high, end);
      y = end, t = high;
      plastic = !plastic;
    }
  }
}

/// In many pieces: the estimate of Fehlberg's 7(8) is zero where the equations do not depend on y, and the step would
/// grow without end.
inline void integrate_in_pieces(const Equations& equations, Values& y, double from, double to, int pieces) {
  for (int k = 0; k < pieces; ++k) {
    integrate(equations, y, from + (to - from) * k / pieces, from + (to - from) * (k + 1) / pieces, 2);
  }
}

inline Tensor velocity_gradient(const History& history, double t) { return history.F_rate(t) * history.F(t).inverse(); }

inline Tensor symmetric_part(const Tensor& A) { return 0.5 * (A + A.transpose()); }

/// f(A) of a symmetric tensor by its eigenvectors.
inline Tensor of_eigenvalues(const Tensor& A, const std::function<double(double)>& f) {
  const Eigen::SelfAdjointEigenSolver<Tensor> eigen(symmetric_part(A));
  const Eigen::Vector3d values = eigen.eigenvalues().unaryExpr(f);
  return eigen.eigenvectors() * values.asDiagonal() * eigen.eigenvectors().transpose();
}

inline Tensor log_of(const Tensor& A) {
  return of_eigenvalues(A, [](double x) { return std::log(x); });
}
inline Tensor root_of(const Tensor& A) {
  return of_eigenvalues(A, [](double x) { return std::sqrt(x); });
}

inline Tensor deviator_of(const Tensor& A) { return A - A.trace() / 3 * Tensor::Identity(); }

struct Lame {
  double lambda, mu;
  Lame(double E, double nu) : lambda(E * nu / (1 + nu) / (1 - 2 * nu)), mu(E / 2 / (1 + nu)) {}
  double kappa() const { return lambda + 2 * mu / 3; }
  Tensor operator()(const Tensor& e) const { return lambda * e.trace() * Tensor::Identity() + 2 * mu * e; }
};

}  // namespace assay::model_tests
