// SPDX-License-Identifier: BSD-3-Clause
// Plastic and viscous models under mixed control against closed forms: docs/paths.md. ln U and the Kirchhoff stress
// make the equations of small strains exact.
#include <gtest/gtest.h>

#include "tests/harness/control/control_rows.hpp"

namespace assay::test_closed_forms_inelastic {
namespace {

constexpr double tolerance = 1e-10;  ///< relative to the largest value

constexpr double E = 1000, nu = 0.3, mu = E / 2 / (1 + nu), kappa = E / 3 / (1 - 2 * nu);
constexpr double Y = 10, H = 20;
const std::map<std::string, double> plastic{{"E", E}, {"nu", nu}, {"yield_stress", Y}, {"hardening_modulus", H}};
constexpr double rate = 0.5, reference = 30;
std::map<std::string, double> viscous(double exponent) {
  return {{"E", E}, {"nu", nu}, {"reference_rate", rate}, {"reference_stress", reference}, {"exponent", exponent}};
}

/// tau = Y + E_T (e - Y/E), E_T = E H / (E + H); e22 = -nu tau / E - e_p / 2.
TEST(InelasticControl, BilinearTension) {
  const auto material = builtin_material(assay_builtin_j2_multiplicative, plastic);
  for (const ControlledRow& row :
       follow_control(*material, along_1([](double t) { return 0.05 * t; }), even_times(1, 50)).rows) {
    const double e = 0.05 * row.t, tau = e < Y / E ? E * e : Y + E * H / (E + H) * (e - Y / E);
    EXPECT_NEAR(row.s(0, 0), tau, tolerance * Y) << row.t;
    EXPECT_NEAR(row.q(1, 1), -nu * tau / E - 0.5 * (e - tau / E), tolerance) << row.t;
  }
}

/// By increments that are exact where the strain does not turn: |tau| <= Y + H p.
TEST(InelasticControl, BilinearCycles) {
  const auto material = builtin_material(assay_builtin_j2_multiplicative, plastic);
  Control control = along_1([](double t) { return t < 1 ? 0.04 * t : t < 3 ? 0.04 * (2 - t) : 0.04 * (t - 4); });
  control.knots = {0, 1, 3, 4};
  const auto rows = follow_control(*material, control, even_times(4, 80)).rows;
  double p = 0, plastic_strain = 0;
  for (const ControlledRow& row : rows) {
    const double trial = E * (row.q(0, 0) - plastic_strain), over = std::abs(trial) - (Y + H * p);
    if (over > 0) {
      p += over / (E + H);
      plastic_strain += std::copysign(over / (E + H), trial);
    }
    EXPECT_NEAR(row.s(0, 0), E * (row.q(0, 0) - plastic_strain), tolerance * Y) << row.t;
  }
  EXPECT_GT(p, 0.1);
}

/// Constant stress from t = 0 on: e = tau / E + rate (tau / reference)^n t.
TEST(InelasticControl, CreepOfNorton) {
  for (const double exponent : {1.0, 3.0, 5.5}) {
    const auto material = builtin_material(assay_builtin_norton, viscous(exponent));
    const auto rows = follow_control(*material, stressed_along_1([](double) { return 12.0; }), even_times(1, 10)).rows;
    ASSERT_EQ(rows.size(), 12u);  // at rest, behind the jump, and ten
    for (std::size_t k = 1; k < rows.size(); ++k) {
      const double creep = rate * std::pow(12 / reference, exponent) * rows[k].t;
      EXPECT_NEAR(rows[k].q(0, 0), 12 / E + creep, tolerance * rows.back().q(0, 0)) << exponent << " " << rows[k].t;
      EXPECT_NEAR(rows[k].q(1, 1), -nu * 12 / E - 0.5 * creep, tolerance * rows.back().q(0, 0));
    }
  }
}

/// A strain that is held, of a Maxwell body (Norton with exponent 1): tau = E e exp(-E rate t / reference).
TEST(InelasticControl, RelaxationOfMaxwell) {
  const auto material = builtin_material(assay_builtin_norton, viscous(1));
  const auto rows = follow_control(*material, along_1([](double) { return 0.02; }), even_times(1, 10)).rows;
  for (std::size_t k = 1; k < rows.size(); ++k)
    EXPECT_NEAR(rows[k].s(0, 0), 0.02 * E * std::exp(-E * rate * rows[k].t / reference), tolerance * 0.02 * E);
}

/// In shear: tau12 = 2 mu e12 exp(-3 mu rate t / reference), and no other stress.
TEST(InelasticControl, RelaxationInShear) {
  const auto material = builtin_material(assay_builtin_norton, viscous(1));
  const Control control = control_of(Deformation::logarithmic_strain, StressMeasure::kirchhoff,
                                     {deformation_row("12", [](double) { return 0.01; }), stress_row("11", zero),
                                      stress_row("22", zero), stress_row("33", zero)},
                                     {"13", "23"});
  const auto rows = follow_control(*material, control, even_times(1, 10)).rows;
  for (std::size_t k = 1; k < rows.size(); ++k) {
    EXPECT_NEAR(rows[k].s(0, 1), 0.02 * mu * std::exp(-3 * mu * rate * rows[k].t / reference), tolerance * 0.02 * mu);
    EXPECT_LT(std::abs(rows[k].s(0, 0)), tolerance * 0.02 * mu);
  }
}

constexpr double k = 15, friction = 0.2, dilatancy = 0.1, pressure = 20;
const std::map<std::string, double> soil{
    {"E", E}, {"nu", nu}, {"cohesion", k}, {"friction", friction}, {"dilatancy", dilatancy}};
const double root3 = std::sqrt(3.0);

/// Triaxial compression under the confining stress -p, from that stress on. The deviator q = tau11 - tau33 has its peak
/// at q / sqrt(3) - friction (3 p + q) = k; behind it the plastic strains go as dilatancy - 1/sqrt(3) along the axis
/// and dilatancy + 1 / (2 sqrt(3)) across it.
TEST(InelasticControl, TriaxialCompressionOfDruckerPrager) {
  const auto material = builtin_material(assay_builtin_drucker_prager, soil);
  Control control = control_of(
      Deformation::logarithmic_strain, StressMeasure::kirchhoff,
      {deformation_row("33", [](double t) { return -0.2 * t; }), stress_row("11", [](double) { return -pressure; }),
       stress_row("22", [](double) { return -pressure; })},
      {"12", "13", "23"});
  control.initial_cauchy = -pressure * Tensor::Identity();
  const auto found = follow_control(*material, control, even_times(1, 40));
  ASSERT_EQ(found.outcome, ControlOutcome::completed) << found.reason;
  const double peak = (k + 3 * friction * pressure) / (1 / root3 - friction);
  for (const ControlledRow& row : found.rows) {
    const double axial = -0.2 * row.t, q = std::min(peak, -E * axial), flow = axial + q / E;
    const double across = nu * q / E + flow * (dilatancy + 0.5 / root3) / (dilatancy - 1 / root3);
    EXPECT_NEAR(row.s(0, 0) - row.s(2, 2), q, tolerance * peak) << row.t;
    EXPECT_NEAR(row.q(0, 0), across, tolerance) << row.t;
  }
}

/// Volume held: elastic until q = sqrt(3) (k + 3 friction p). Then dilatancy presses the mean stress up, and q with it
/// along the cone: by a flow Lam, d(mean stress) = -3 kappa dilatancy Lam.
TEST(InelasticControl, UndrainedShearOfDruckerPrager) {
  const auto material = builtin_material(assay_builtin_drucker_prager, soil);
  Control control = control_of(Deformation::logarithmic_strain, StressMeasure::kirchhoff,
                               {deformation_row("33", [](double t) { return -0.2 * t; })}, {"12", "13", "23"});
  ControlRow volume, alike;
  volume.deformation.setIdentity();
  alike.stress(0, 0) = 1, alike.stress(1, 1) = -1;
  volume.value = alike.value = [](double, bool) { return 0.0; };
  control.rows.push_back(volume);
  control.rows.push_back(alike);
  control.initial_cauchy = -pressure * Tensor::Identity();
  const auto found = follow_control(*material, control, even_times(1, 40));
  ASSERT_EQ(found.outcome, ControlOutcome::completed) << found.reason;
  const double first = root3 * (k + 3 * friction * pressure);
  for (const ControlledRow& row : found.rows) {
    const double strain = 0.2 * row.t, trial = 3 * mu * strain;  // q of an elastic step
    double q = trial, mean = -pressure;
    if (trial > first) {
      const double Lam = (trial - first) / root3 / (mu + 9 * kappa * friction * dilatancy);
      q = trial - root3 * mu * Lam, mean = -pressure - 3 * kappa * dilatancy * Lam;
    }
    EXPECT_NEAR(row.s(0, 0) - row.s(2, 2), q, tolerance * first) << row.t;
    EXPECT_NEAR(row.s.trace() / 3, mean, tolerance * first) << row.t;
    EXPECT_NEAR(row.q(0, 0), 0.5 * strain, tolerance);
  }
}

}  // namespace
}  // namespace assay::test_closed_forms_inelastic
