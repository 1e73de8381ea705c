// SPDX-License-Identifier: BSD-3-Clause
// Non-proportional tension and torsion of a metal with kinematic hardening, against Boost.Odeint on its rate form.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <numbers>

#include "harness/numeric/stiff_integrator.hpp"
#include "tests/harness/control/control_rows.hpp"

namespace assay::test_tension_torsion {
namespace {

constexpr double tolerance = 1e-8;  ///< relative, of stress and strain

constexpr double E = 1000, nu = 0.3, mu = E / 2 / (1 + nu), lambda = E * nu / (1 + nu) / (1 - 2 * nu);
constexpr double yield = 10, kinematic = 60, isotropic = 15;  // [Pa]
const double radius = std::sqrt(2.0 / 3) * yield;

Tensor deviator(const Tensor& A) { return A - A.trace() / 3 * Tensor::Identity(); }
Tensor hooke(const Tensor& e) { return lambda * e.trace() * Tensor::Identity() + 2 * mu * e; }
Tensor log_of_stretch(const Tensor& F) {
  const Eigen::SelfAdjointEigenSolver<Tensor> spectrum(F.transpose() * F);
  return spectrum.eigenvectors() * (0.5 * spectrum.eigenvalues().array().log()).matrix().asDiagonal() *
         spectrum.eigenvectors().transpose();
}

/// Additive plasticity in ln U with linear kinematic and isotropic hardening; F = U. State: plastic strain, back stress
/// (9 each), p.
assay_material law() {
  static const assay_state_variable state[] = {{"plastic_strain", "1", ASSAY_TENSOR, ASSAY_ROLE_PLAIN, ""},
                                               {"back_stress", "Pa", ASSAY_TENSOR, ASSAY_ROLE_PLAIN, ""},
                                               {"p", "1", ASSAY_SCALAR, ASSAY_ROLE_PLAIN, ""}};
  assay_material table{};
  table.abi_major = ASSAY_ABI_MAJOR, table.struct_size = sizeof table;
  table.name = "kinematic", table.version = "1", table.licence = table.doc = "test";
  table.flags = ASSAY_NON_SMOOTH;
  table.state_count = 3, table.state = state;
  table.create = [](const double*, char*) -> void* {
    static char self;
    return &self;
  };
  table.destroy = [](void*) {};
  table.initial_state = [](void*, std::size_t n, const double*, double* out) -> std::int32_t {
    std::fill_n(out, 19 * n, 0.0);
    return ASSAY_GOOD;
  };
  table.update = [](void*, const assay_step* step, std::size_t n, const double* state0, double* state1, double* cauchy,
                    std::int32_t* status, double*, char*) {
    for (std::size_t k = 0; k < n; ++k) {
      const Tensor F = tensor_at(step->F1, n, k), e = log_of_stretch(F);
      Tensor plastic = tensor_at(state0, n, k), back = tensor_at(state0 + 9 * n, n, k);
      double p = state0[18 * n + k];
      const Tensor xi = deviator(hooke(e - plastic)) - back;
      const double size = radius + std::sqrt(2.0 / 3) * isotropic * p, over = xi.norm() - size;
      if (over > 0) {
        const double flow = over / (2 * mu + 2.0 / 3 * (kinematic + isotropic));
        plastic += flow * xi / xi.norm();
        back += 2.0 / 3 * kinematic * flow * xi / xi.norm();
        p += std::sqrt(2.0 / 3) * flow;
      }
      put_tensor(plastic, state1, n, k);
      put_tensor(back, state1 + 9 * n, n, k);
      state1[18 * n + k] = p;
      put_tensor(Tensor(hooke(e - plastic) / F.determinant()), cauchy, n, k);
      status[k] = ASSAY_GOOD;
    }
  };
  return table;
}

/// e11 and e12 go round an ellipse; faces 2 and 3 are free.
constexpr double peak = 0.03, omega = 2 * std::numbers::pi;
double axial(double t) { return peak * std::sin(omega * t); }
double shear(double t) { return peak * (1 - std::cos(omega * t)); }

/// Rates of (e22, e33, plastic strain 11 22 33 12, back stress 11 22 33 12, p) while it flows: tau22 and tau33 stay
/// zero.
void slope(const std::vector<double>& y, double t, std::vector<double>& rate) {
  const auto plane = [](double a, double b, double c, double d) {
    Tensor A;
    A << a, d, 0, d, b, 0, 0, 0, c;
    return A;
  };
  const Tensor plastic = plane(y[2], y[3], y[4], y[5]), back = plane(y[6], y[7], y[8], y[9]);
  const Tensor e = plane(axial(t), y[0], y[1], shear(t));
  const Tensor xi = deviator(hooke(e - plastic)) - back, N = xi / xi.norm();
  const double modulus = 2 * mu + 2.0 / 3 * (kinematic + isotropic);
  const auto flow_of = [&](const Tensor& strain_rate) { return 2 * mu * N.cwiseProduct(strain_rate).sum() / modulus; };
  const auto stress_rate = [&](const Tensor& strain_rate) {
    return Tensor(hooke(strain_rate - flow_of(strain_rate) * N));
  };
  Tensor strain_rate = plane(peak * omega * std::cos(omega * t), 0, 0, peak * omega * std::sin(omega * t));
  const Tensor given = stress_rate(strain_rate), by_22 = stress_rate(plane(0, 1, 0, 0)),
               by_33 = stress_rate(plane(0, 0, 1, 0));
  Eigen::Matrix2d A;
  A << by_22(1, 1), by_33(1, 1), by_22(2, 2), by_33(2, 2);
  const Eigen::Vector2d free = -(A.inverse() * Eigen::Vector2d(given(1, 1), given(2, 2)));
  strain_rate(1, 1) = free(0), strain_rate(2, 2) = free(1);
  const double flow = flow_of(strain_rate);
  rate = {free(0),
          free(1),
          flow * N(0, 0),
          flow * N(1, 1),
          flow * N(2, 2),
          flow * N(0, 1),
          2.0 / 3 * kinematic * flow * N(0, 0),
          2.0 / 3 * kinematic * flow * N(1, 1),
          2.0 / 3 * kinematic * flow * N(2, 2),
          2.0 / 3 * kinematic * flow * N(0, 1),
          std::sqrt(2.0 / 3) * flow};
}

/// Elastic until it yields: tau = (E e11, 2 mu e12), |xi| = radius.
double yield_time() {
  double low = 0, high = 0.25;
  for (int i = 0; i < 200; ++i) {
    const double t = 0.5 * (low + high), tau = E * axial(t), q = 2 * mu * shear(t);
    (tau * tau + 3 * q * q > yield * yield ? high : low) = t;
  }
  return low;
}

TEST(TensionTorsion, OfKinematicHardeningAgainstOdeint) {
  const assay_material table = law();
  const Material material(&table, {});
  const Control control = control_of(
      Deformation::logarithmic_strain, StressMeasure::kirchhoff,
      {deformation_row("11", axial), deformation_row("12", shear), stress_row("22", zero), stress_row("33", zero)},
      {"13", "23"});
  const auto found = follow_control(material, control, even_times(1, 10));
  ASSERT_EQ(found.outcome, ControlOutcome::completed) << found.reason;
  double t = yield_time(), step = 1e-4;
  std::vector<double> y(11, 0.0);
  y[0] = y[1] = -nu * axial(t);
  for (const ControlledRow& row : found.rows) {
    if (row.t < t) continue;
    const StiffOptions options{.tolerance = 1e-12, .shortest = 1e-14, .window_begin = t, .window_end = 1};
    ASSERT_GE(integrate_stiff(slope, y, t, row.t, step, options), 0);
    EXPECT_NEAR(row.q(1, 1), y[0], tolerance * peak) << row.t;
    EXPECT_NEAR(row.q(2, 2), y[1], tolerance * peak) << row.t;
    EXPECT_NEAR(row.state[18], y[10], tolerance) << row.t;
    EXPECT_NEAR(row.s(0, 0), E * (axial(t) - y[2]), tolerance * yield) << row.t;
    EXPECT_NEAR(row.s(0, 1), 2 * mu * (shear(t) - y[5]), tolerance * yield) << row.t;
  }
  EXPECT_GT(y[10], 0.1) << "it has flowed";
}

}  // namespace
}  // namespace assay::test_tension_torsion
