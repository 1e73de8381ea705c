// SPDX-License-Identifier: BSD-3-Clause
// Rows with J and ln J against closed forms of neo-Hookean, (34): sigma = (lambda ln J I + mu (F F^T - I)) / J.
#include <gtest/gtest.h>

#include "tests/harness/control/control_rows.hpp"

namespace assay::test_volume_rows {
namespace {

constexpr double tolerance = 1e-10;  ///< relative to the largest stress, as of all closed forms of paths
constexpr double E = 1000, nu = 0.3, mu = E / 2 / (1 + nu), lambda = E * nu / (1 + nu) / (1 - 2 * nu);

ControlRow volume_row(double ln_J, double J, Of value) {
  ControlRow row;
  row.ln_J = ln_J, row.J = J;
  row.value = [value = std::move(value)](double t, bool) { return value(t); };
  return row;
}

ControlRow alike(const char* one, const char* other, bool of_stress) {
  ControlRow row = of_stress ? stress_row(one, zero) : deformation_row(one, zero);
  (of_stress ? row.stress : row.deformation)(other[0] - '1', other[1] - '1') -= 1;
  return row;
}

ControlledHistory followed(const Control& control) {
  const auto material = builtin_material(assay_builtin_neo_hookean, {{"E", E}, {"nu", nu}});
  return follow_control(*material, control, even_times(1, 10));
}

constexpr std::initializer_list<const char*> shears{"12", "13", "23", "21", "31", "32"};

TEST(VolumeRows, PrescribeLnJBesideF) {
  const auto stretch = [](double t) { return 1 + 0.3 * t; };
  const auto ln_J = [](double t) { return 0.1 * t; };
  const Control control =
      control_of(Deformation::gradient, StressMeasure::cauchy,
                 {deformation_row("11", stretch), volume_row(1, 0, ln_J), alike("22", "33", true)}, shears);
  const ControlledHistory found = followed(control);
  ASSERT_EQ(found.outcome, ControlOutcome::completed);
  for (const ControlledRow& row : found.rows) {
    const double J = std::exp(ln_J(row.t)), l2 = std::sqrt(J / stretch(row.t));
    EXPECT_NEAR(row.F.determinant(), J, tolerance);
    EXPECT_NEAR(row.F(1, 1), l2, tolerance);
    EXPECT_NEAR(row.s(1, 1), (lambda * ln_J(row.t) + mu * (l2 * l2 - 1)) / J, tolerance * E);
  }
}

/// Uniaxial stress, driven by J: lambda ln J + mu (l2^2 - 1) = 0.
TEST(VolumeRows, PrescribeJInAnyMeasure) {
  const auto J = [](double t) { return 1 + 0.08 * t; };
  for (const Deformation deformation :
       {Deformation::gradient, Deformation::logarithmic_strain, Deformation::velocity_gradient}) {
    Control control = control_of(deformation, StressMeasure::cauchy,
                                 {volume_row(0, 1, J), stress_row("22", zero), stress_row("33", zero)});
    for (const char* ij : shears) {
      if (deformation != Deformation::logarithmic_strain || ij[0] < ij[1])
        control.rows.push_back(deformation_row(ij, zero));
    }
    const ControlledHistory found = followed(control);
    ASSERT_EQ(found.outcome, ControlOutcome::completed);
    for (const ControlledRow& row : found.rows) {
      const double l2 = std::sqrt(1 - lambda / mu * std::log(J(row.t)));
      EXPECT_NEAR(row.F(0, 0), J(row.t) / (l2 * l2), tolerance);
    }
  }
}

/// A fluid of bulk modulus K in the pores bears K ln J of the mean stress that acts outside.
TEST(VolumeRows, RelateTheStressToTheVolume) {
  constexpr double K = 700;
  const auto outside = [](double t) { return -200 * t; };
  ControlRow total = volume_row(K, 0, outside);
  total.stress = Tensor::Identity() / 3;
  const Control control = control_of(Deformation::gradient, StressMeasure::cauchy,
                                     {total, alike("22", "11", false), alike("33", "11", false)}, shears);
  const ControlledHistory found = followed(control);
  ASSERT_EQ(found.outcome, ControlOutcome::completed);
  for (const ControlledRow& row : found.rows) {
    double low = 0.5, high = 1.5;  // of the stretch a: sigma + 3 K ln a rises with it
    for (int i = 0; i < 100; ++i) {
      const double a = 0.5 * (low + high), J = a * a * a;
      const double sum = (lambda * std::log(J) + mu * (a * a - 1)) / J + K * std::log(J);
      (sum < outside(row.t) ? low : high) = a;
    }
    EXPECT_NEAR(row.F(0, 0), low, tolerance);
  }
}

TEST(VolumeRows, AHistoryEndsWhereItsWatcherSays) {
  const Control control = along_1([](double t) { return 0.1 * t; });
  const auto material = builtin_material(assay_builtin_neo_hookean, {{"E", E}, {"nu", nu}});
  ControlOptions options;
  double reached = 0;
  options.progress = [&](double share) { reached = share; };
  options.ends = [&] { return reached > 0.45; };
  const ControlledHistory found = follow_control(*material, control, even_times(1, 10), options);
  EXPECT_EQ(found.outcome, ControlOutcome::interrupted);
  ASSERT_GT(found.rows.size(), 4u);
  EXPECT_LT(found.rows.back().t, 1);
  EXPECT_GT(found.rows.back().t, 0.45);
}

}  // namespace
}  // namespace assay::test_volume_rows
