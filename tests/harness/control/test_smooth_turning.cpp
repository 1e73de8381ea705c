// SPDX-License-Identifier: BSD-3-Clause
// Loading that ends, and begins again, between the times at which a history stops, on paths without a kink.
#include <gtest/gtest.h>

#include <numbers>

#include "tests/harness/control/control_rows.hpp"

namespace assay::test_smooth_turning {
namespace {

constexpr double tolerance = 1e-9;  ///< of the largest value: a hundred times what a step is asked for
constexpr int paths = 6;

/// A component that goes up and down on its own clock.
Of wave(double mean, double size, double turns, double phase = 0) {
  return [=](double t) { return mean + size * std::sin(2 * std::numbers::pi * turns * t + phase); };
}

/// Different for each k; no two components turn at one time.
Control all_prescribed(int k, double size) {
  std::vector<ControlRow> rows;
  const char* names[] = {"11", "12", "13", "21", "22", "23", "31", "32", "33"};
  for (int c = 0; c < 9; ++c) {
    const double share = 0.3 + 0.1 * ((3 * k + 5 * c) % 8), turns = 0.45 + 0.07 * ((2 * k + 3 * c) % 9);
    rows.push_back(deformation_row(names[c], wave(c % 4 == 0 ? 1 : 0, size * (c % 2 ? -share : share), turns)));
  }
  return control_of(Deformation::gradient, StressMeasure::cauchy, rows);
}

double energy(const Tensor& F, double E, double nu) {
  const double mu = E / (2 * (1 + nu)), lambda = E * nu / ((1 + nu) * (1 - 2 * nu)), ln_J = std::log(F.determinant());
  return mu / 2 * (F.squaredNorm() - 3 - 2 * ln_J) + lambda / 2 * ln_J * ln_J;
}

/// The damage is that of the largest energy so far, which follows from F alone.
TEST(SmoothTurning, DamageKnowsTheLargestEnergy) {
  const std::map<std::string, double> soft{{"E", 1000}, {"nu", 0.3}, {"kappa_0", 0.1}, {"kappa_f", 20}, {"D_max", 0.8}};
  const auto material = builtin_material(assay_builtin_damage, soft);
  for (int k = 0; k < paths; ++k) {
    const Control control = all_prescribed(k, 0.1);
    const auto gradient = [&](double t) {
      Tensor F;
      for (int c = 0; c < 9; ++c) F(c / 3, c % 3) = control.rows[static_cast<std::size_t>(c)].value(t, false);
      return F;
    };
    double largest = soft.at("kappa_0");
    constexpr int samples = 200'000;  // a maximum is flat: its value is known to 1e-10
    for (int i = 0; i <= samples; ++i)
      largest = std::max(largest, energy(gradient(static_cast<double>(i) / samples), 1000, 0.3));
    const auto found = follow_control(*material, control, even_times(1, 12));
    ASSERT_EQ(found.outcome, ControlOutcome::completed) << found.reason;
    EXPECT_NEAR(found.rows.back().state[0], largest, tolerance * largest) << "path " << k;
  }
}

/// Values at a time do not depend on how many others are asked for.
void expect_same_at_all_counts(const Material& material, const Control& control, const std::string& what) {
  const auto fine = follow_control(material, control, even_times(1, 960));
  ASSERT_EQ(fine.outcome, ControlOutcome::completed) << what << fine.reason;
  double largest = 0;
  for (const ControlledRow& row : fine.rows) largest = std::max(largest, row.s.cwiseAbs().maxCoeff());
  for (const int count : {10, 24, 60}) {
    const auto coarse = follow_control(material, control, even_times(1, count));
    ASSERT_EQ(coarse.outcome, ControlOutcome::completed) << what << coarse.reason;
    EXPECT_LT((coarse.rows.back().s - fine.rows.back().s).cwiseAbs().maxCoeff(), tolerance * largest)
        << what << ", " << count << " rows";
  }
}

TEST(LongSmoothTurning, MetalsUnloadWhereTheyTurn) {
  const std::map<std::string, double> metal{
      {"E", 1000}, {"nu", 0.3}, {"yield_stress", 8}, {"hardening_modulus", 50}, {"kinematic_modulus", 60}};
  for (const assay_material* model :
       {assay_builtin_j2_jaumann(ASSAY_ABI_MAJOR, 0), assay_builtin_j2_multiplicative(ASSAY_ABI_MAJOR, 0)}) {
    const Material material(model, metal);
    for (int k = 0; k < paths; ++k)
      expect_same_at_all_counts(material, all_prescribed(k, 0.02),
                                std::string(model->name) + ", path " + std::to_string(k));
  }
}

/// Of a soil, and of a metal with two free faces.
TEST(SmoothTurning, SoilsAndFreeFacesDoSoToo) {
  const auto soil = builtin_material(
      assay_builtin_drucker_prager,
      {{"E", 1000}, {"nu", 0.2}, {"cohesion", 10}, {"friction", 0.2}, {"dilatancy", 0.1}, {"hardening_modulus", 50}});
  Control pressed = all_prescribed(1, 0.02);
  pressed.rows[0].value = [](double t, bool) { return 1 - 0.03 * t + 0.01 * std::sin(9 * t); };
  expect_same_at_all_counts(*soil, pressed, "drucker_prager");
  const auto metal = builtin_material(
      assay_builtin_j2_jaumann,
      {{"E", 1000}, {"nu", 0.3}, {"yield_stress", 8}, {"hardening_modulus", 50}, {"kinematic_modulus", 60}});
  const Control free_faces =
      control_of(Deformation::logarithmic_strain, StressMeasure::cauchy,
                 {deformation_row("11", wave(0, 0.03, 0.9)), deformation_row("12", wave(0, 0.02, 0.65)),
                  stress_row("22", zero), stress_row("33", zero)},
                 {"13", "23"});
  expect_same_at_all_counts(*metal, free_faces, "j2_jaumann, free faces");
}

}  // namespace
}  // namespace assay::test_smooth_turning
