// SPDX-License-Identifier: BSD-3-Clause
// One point of a model at chosen states of chosen paths: its derivatives, and the integration of its rate form.
#pragma once

#include <gtest/gtest.h>

#include "tests/adapters/models/reference_integration.hpp"

namespace assay::model_tests {

using Path = std::function<Tensor(double)>;

inline Point at_rest(const Material& material) { return {Tensor::Zero(), material.initial_state(1)}; }

/// n equal steps from t0 to t1.
inline Point march(const Material& material, const Path& F, double t0, double t1, int n, Point from) {
  const double dt = (t1 - t0) / n;
  for (int k = 0; k < n; ++k) {
    from = point_after(material, t0 + k * dt, dt, F(t0 + k * dt), F(t0 + (k + 1) * dt), from.state);
  }
  return from;
}

/// Velocity gradient Fdot F^-1 by differences of fourth order.
inline Tensor velocity_gradient(const Path& F, double t) {
  const double h = 1e-4;
  const Tensor slope = (8 * (F(t + h) - F(t - h)) - (F(t + 2 * h) - F(t - 2 * h))) / (12 * h);
  return slope * F(t).inverse();
}

/// Under error control at 1e-12, in many pieces: the estimate of Fehlberg's 7(8) is zero where the equations do not
/// depend on y, and the step would grow without end.
inline Values integrate_in_pieces(const Equations& equations, Values y, double from, double to) {
  constexpr int pieces = 400;
  for (int k = 0; k < pieces; ++k) {
    integrate(equations, y, from + (to - from) * k / pieces, from + (to - from) * (k + 1) / pieces);
  }
  return y;
}

inline std::array<double, 9> components_of(const Tensor& A) {
  std::array<double, 9> a;
  nine(A, a.data());
  return a;
}

inline double largest(const Tensor& A) { return A.cwiseAbs().maxCoeff(); }

/// d cauchy / d F1 as an extension gives it and by central differences: the largest difference over the largest
/// component. `planted` is added to the first component of the former.
inline double tangent_error(const Material& material, double dt, const Tensor& F0, const Tensor& F1,
                            const Values& state, double planted = 0) {
  const auto* table = material.extension<assay_tangent>(ASSAY_EXTENSION_TANGENT);
  const auto a = components_of(F0), b = components_of(F1);
  const assay_step one{0, dt, a.data(), b.data()};
  std::array<double, 81> tangent;
  if (!table || table->tangent(material.self(), &one, 1, state.data(), tangent.data()) != ASSAY_GOOD) return 1e300;
  tangent[0] *= 1 + planted;
  double difference = 0, scale = 0;
  const double h = 1e-6;
  for (int j = 0; j < 9; ++j) {
    Tensor up = F1, down = F1;
    component(up, j) += h;
    component(down, j) -= h;
    const Tensor slope =
        (point_after(material, 0, dt, F0, up, state).cauchy - point_after(material, 0, dt, F0, down, state).cauchy) /
        (2 * h);
    for (int i = 0; i < 9; ++i) {
      difference = std::max(difference, std::abs(component(slope, i) - tangent[static_cast<std::size_t>(9 * i + j)]));
      scale = std::max(scale, std::abs(component(slope, i)));
    }
  }
  return difference / scale;
}

/// P against dW/dF by central differences at a fixed state, over the largest component of P.
inline double energy_error(const Material& material, const Tensor& F, const Point& at) {
  const auto* table = material.extension<assay_energy>(ASSAY_EXTENSION_ENERGY);
  if (!table) return 1e300;
  const Tensor P = first_piola_kirchhoff(at.cauchy, F);
  const auto W = [&](const Tensor& G) {
    const auto g = components_of(G);
    double energy = 0;
    table->energy(material.self(), 1, g.data(), at.state.data(), &energy);
    return energy;
  };
  double difference = 0;
  const double h = 1e-4;
  for (int j = 0; j < 9; ++j) {
    const auto moved = [&](double by) {
      Tensor G = F;
      component(G, j) += by;
      return W(G);
    };
    const double slope = (8 * (moved(h) - moved(-h)) - (moved(2 * h) - moved(-2 * h))) / (12 * h);
    difference = std::max(difference, std::abs(slope - component(P, j)));
  }
  return difference / largest(P);
}

/// The model's own rate form integrated along the path from `from`.
inline Point integrate_rate(const Material& material, const Path& F, const Point& from, double t0, double t1) {
  const auto* table = material.extension<assay_rate>(ASSAY_EXTENSION_RATE);
  Values y(9 + from.state.size());
  const auto sigma = components_of(from.cauchy);
  std::copy(sigma.begin(), sigma.end(), y.begin());
  std::copy(from.state.begin(), from.state.end(), y.begin() + 9);
  const auto slope = [&](const Values& now, Values& rate, double t) {
    const auto f = components_of(F(t)), l = components_of(velocity_gradient(F, t));
    table->rate(material.self(), t, 1, f.data(), l.data(), now.data(), now.data() + 9, rate.data(), rate.data() + 9);
  };
  y = integrate_in_pieces(slope, y, t0, t1);
  return {tensor_of(y.data()), {y.begin() + 9, y.end()}};
}

/// max |Q^T sigma Q - sigma_0| / max |sigma_0| where the frame turns about (1,2,3) all along the path.
inline double objectivity_error(const Material& material, const Path& F, double t1, int n) {
  const auto Q = [](double t) {
    return Eigen::AngleAxisd(0.7 + 1.9 * t, Vector3(1, 2, 3).normalized()).toRotationMatrix();
  };
  const Point plain = march(material, F, 0, t1, n, at_rest(material));
  const Point turned = march(
      material, [&](double t) { return Tensor(Q(t) * F(t)); }, 0, t1, n, at_rest(material));
  return largest(Q(t1).transpose() * turned.cauchy * Q(t1) - plain.cauchy) / largest(plain.cauchy);
}

/// Stretch, shear and rotation about (1,2,3) at once; F(0) = I.
inline Tensor stretched_and_turned(double t, double amount) {
  Tensor U;
  U << 1 + amount * std::sin(2 * t), 0.4 * amount * t, 0.1 * amount * std::sin(t),  //
      0.4 * amount * t, 1 - 0.5 * amount * std::sin(3 * t), 0.3 * amount * t * t,   //
      0.1 * amount * std::sin(t), 0.3 * amount * t * t, 1 + 0.3 * amount * std::sin(t);
  return Eigen::AngleAxisd(1.3 * t, Vector3(1, 2, 3).normalized()).toRotationMatrix() * U;
}

/// F = I + gamma E2 E1.
inline Tensor sheared(double gamma) {
  Tensor F = Tensor::Identity();
  F(1, 0) = gamma;
  return F;
}

/// The closed form of a baseline against `update` at eps, and its slope against differences of itself, each over the
/// largest component; 1e300 where there is none.
inline std::pair<double, double> closed_form_errors(const Material& material, int baseline, double eps) {
  const auto* table = material.extension<assay_closed_form>(ASSAY_EXTENSION_CLOSED_FORM);
  if (!table) return {1e300, 1e300};
  const auto form = [&](double at, Tensor& slope) {
    std::array<double, 9> tau, dtau;
    if (table->tau(material.self(), baseline, 1, &at, tau.data(), dtau.data()) != ASSAY_GOOD) tau.fill(1e300);
    slope = tensor_of(dtau.data());
    return tensor_of(tau.data());
  };
  Tensor F = Tensor::Identity(), slope, unused;
  if (baseline == ASSAY_BASELINE_SIMPLE_SHEAR) F(1, 0) = 2 * eps;
  if (baseline == ASSAY_BASELINE_UNIAXIAL_STRAIN) F(0, 0) = 1 + eps;
  const Tensor tau = form(eps, slope);
  if (largest(tau) >= 1e300) return {1e300, 1e300};
  const Tensor P =
      first_piola_kirchhoff(point_after(material, 0, 1, Tensor::Identity(), F, material.initial_state(1)).cauchy, F);
  const double h = 1e-4;
  const Tensor differences =
      (8 * (form(eps + h, unused) - form(eps - h, unused)) - (form(eps + 2 * h, unused) - form(eps - 2 * h, unused))) /
      (12 * h);
  return {largest(tau - P) / largest(P), largest(differences - slope) / largest(slope)};
}

/// One step from rest without state.
inline Point deformed(const Material& material, const Tensor& F) {
  return point_after(material, 0, 1, Tensor::Identity(), F, material.initial_state(1));
}

/// The stress is the derivative of the energy, the tangent that of the stress, both objective; errors of 1e-4 are seen.
inline void expect_hyperelastic(const Material& material) {
  const Tensor F = stretched_and_turned(0.9, 0.5);
  Point point = deformed(material, F);
  EXPECT_LT(energy_error(material, F, point), 1e-10);
  EXPECT_LT(tangent_error(material, 1, F, F, {}), 1e-6);
  EXPECT_GT(tangent_error(material, 1, F, F, {}, 1e-4), 1e-6);
  EXPECT_LT(objectivity_error(
                material, [](double t) { return stretched_and_turned(t, 0.5); }, 0.9, 3),
            1e-13);
  point.cauchy(0, 1) *= 1.0001;
  EXPECT_GT(energy_error(material, F, point), 1e-7);
}

/// Simple shear and uniaxial strain in compression, near rest and in tension.
inline void expect_closed_forms(const Material& material) {
  for (const int baseline : {ASSAY_BASELINE_SIMPLE_SHEAR, ASSAY_BASELINE_UNIAXIAL_STRAIN}) {
    for (const double eps : {-0.6, 0.01, 1.7}) {
      const auto [value, slope] = closed_form_errors(material, baseline, eps);
      EXPECT_LT(value, 1e-12) << baseline << ' ' << eps;
      EXPECT_LT(slope, 1e-10) << baseline << ' ' << eps;
    }
  }
}

}  // namespace assay::model_tests
