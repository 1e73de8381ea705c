// SPDX-License-Identifier: BSD-3-Clause
#include "harness/control/controlled_history.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/harness/control/control_rows.hpp"

namespace assay::test_controlled_history {
namespace {

const std::map<std::string, double> elastic{{"E", 1000}, {"nu", 0.3}};
std::map<std::string, double> plastic(double hardening) {
  return {{"E", 1000}, {"nu", 0.3}, {"yield_stress", 10}, {"hardening_modulus", hardening}};
}

/// Nothing bears more than the yield stress of a perfectly plastic bar: Cauchy's is Y / J, ln J = (1 - 2 nu) Y / E.
TEST(ControlledHistory, EndsAtTheLimitLoad) {
  const auto material = builtin_material(assay_builtin_j2_multiplicative, plastic(0));
  const auto kirchhoff =
      follow_control(*material, stressed_along_1([](double t) { return 25 * t; }), even_times(1, 10));
  EXPECT_EQ(kirchhoff.outcome, ControlOutcome::limit_load) << kirchhoff.reason;
  EXPECT_NEAR(kirchhoff.rows.back().s(0, 0), 10, 1e-6);
  EXPECT_NEAR(kirchhoff.rows.back().t, 0.4, 1e-6);
  EXPECT_GT(std::abs(kirchhoff.direction(0, 0)), 0.5) << "it runs away along the bar";
  Control control = stressed_along_1([](double t) { return 25 * t; });
  control.stress = StressMeasure::cauchy;
  const auto cauchy = follow_control(*material, control, even_times(1, 10));
  EXPECT_EQ(cauchy.outcome, ControlOutcome::limit_load) << cauchy.reason;
  EXPECT_NEAR(cauchy.rows.back().s(0, 0), 10 / std::exp(0.4 * 10 / 1000), 1e-5);
}

/// Saint Venant-Kirchhoff in compression: P = E lambda (lambda^2 - 1) / 2 has its least value at lambda = 1 / sqrt 3.
TEST(ControlledHistory, EndsAtALimitPoint) {
  const auto material =
      builtin_material(assay_builtin_zener, {{"E", 1000}, {"nu", 0}, {"viscous_ratio", 0}, {"relaxation_time", 1}});
  const auto neo = builtin_material(assay_builtin_neo_hookean, elastic);
  // Hencky's law of J2 that does not yield, in dead load: P = E ln lambda / lambda, at most E / e.
  auto strong = plastic(0);
  strong["yield_stress"] = 1e6, strong["nu"] = 0;
  const auto hencky = builtin_material(assay_builtin_j2_multiplicative, strong);
  Control control = stressed_along_1([](double t) { return 1000 * t; });
  control.stress = StressMeasure::first_piola_kirchhoff;
  const auto found = follow_control(*hencky, control, even_times(1, 10));
  EXPECT_EQ(found.outcome, ControlOutcome::limit_load) << found.reason;
  EXPECT_NEAR(found.rows.back().s(0, 0), 1000 / std::exp(1.0), 1e-5);  // 1e-8 of the load
  EXPECT_NEAR(found.rows.back().q(0, 0), 1, 1e-3);
  EXPECT_EQ(follow_control(*neo, control, even_times(1, 10)).outcome, ControlOutcome::completed);
}

/// Strain goes over the same peak, which a stop finds.
TEST(ControlledHistory, StopsAtAPeak) {
  auto strong = plastic(0);
  strong["yield_stress"] = 1e6, strong["nu"] = 0;
  const auto hencky = builtin_material(assay_builtin_j2_multiplicative, strong);
  Control control = along_1([](double t) { return 2 * t; });
  control.stress = StressMeasure::first_piola_kirchhoff;
  ControlStop peak{ControlStop::When::peak, {}, 0, "peak of P11"};
  peak.quantity.stress(0, 0) = 1;
  control.stops = {peak};
  const auto found = follow_control(*hencky, control, even_times(1, 7));
  EXPECT_EQ(found.outcome, ControlOutcome::stopped) << found.reason;
  EXPECT_EQ(found.reason, "peak of P11");
  EXPECT_NEAR(found.rows.back().s(0, 0), 1000 / std::exp(1.0), 1e-9);
  EXPECT_NEAR(found.rows.back().q(0, 0), 1, 1e-5);
}

TEST(ControlledHistory, StopsWhereAQuantityReachesItsBound) {
  const auto material = builtin_material(assay_builtin_j2_multiplicative, plastic(20));
  Control control = stressed_along_1([](double t) { return 15 * t; });
  ControlStop longer{ControlStop::When::above, {}, 0.1, "e11 above 0.1"};
  longer.quantity.deformation(0, 0) = 1;
  ControlStop thinner{ControlStop::When::below, {}, -0.03, "e22 below -0.03"};
  thinner.quantity.deformation(1, 1) = 1;
  control.stops = {longer};
  auto found = follow_control(*material, control, even_times(1, 7));
  EXPECT_EQ(found.outcome, ControlOutcome::stopped) << found.reason;
  EXPECT_NEAR(found.rows.back().q(0, 0), 0.1, 1e-9);
  EXPECT_NEAR(found.rows.back().s(0, 0), 10 + 1000 * 20 / 1020.0 * (0.1 - 0.01), 1e-7);
  control.stops = {longer, thinner};
  found = follow_control(*material, control, even_times(1, 7));
  EXPECT_EQ(found.reason, "e22 below -0.03");
  EXPECT_NEAR(found.rows.back().q(1, 1), -0.03, 1e-9);
}

/// All nine components of P leave the rotation free.
TEST(ControlledHistory, SaysWhichDeformationIsFree) {
  const auto material = builtin_material(assay_builtin_neo_hookean, elastic);
  Control control = control_of(Deformation::gradient, StressMeasure::first_piola_kirchhoff, {});
  for (const char* ij : {"11", "12", "13", "21", "22", "23", "31", "32", "33"})
    control.rows.push_back(stress_row(ij, [ij](double t) { return ij[0] == ij[1] ? 100 * t : 0; }));
  const auto found = follow_control(*material, control, even_times(1, 2));
  EXPECT_EQ(found.outcome, ControlOutcome::undetermined);
  EXPECT_LT((found.direction + found.direction.transpose()).norm(), 1e-4) << "a rotation";
  EXPECT_NEAR(found.direction.norm(), 1, 1e-6);
}

/// A body under equal dead loads may leave the equal stretches (Rivlin's cube). With tension along 1 and 2 and
/// Mooney-Rivlin's law the matrix of the rows becomes singular there, and a second solution begins.
TEST(ControlledHistory, MarksWhereAnotherSolutionBegins) {
  const auto material = builtin_material(assay_builtin_neo_hookean, elastic);
  const Of load = [](double t) { return 3000 * t; };
  const Control control = control_of(Deformation::gradient, StressMeasure::first_piola_kirchhoff,
                                     {stress_row("11", load), stress_row("22", load), stress_row("33", load)},
                                     {"12", "13", "21", "23", "31", "32"});
  const auto found = follow_control(*material, control, even_times(1, 10));
  ASSERT_EQ(found.outcome, ControlOutcome::completed) << found.reason;
  const ControlledRow& end = found.rows.back();
  EXPECT_NEAR(end.F(0, 0), end.F(1, 1), 1e-9) << "it goes on along the way on which it came";
}

/// Of J2 in simple shear the acoustic tensor has a vanishing eigenvalue where the stress has grown enough.
TEST(ControlledHistory, TellsWhereEllipticityIsLost) {
  const auto material = builtin_material(assay_builtin_hypoelastic_jaumann, elastic);
  Control control = control_of(Deformation::gradient, StressMeasure::cauchy,
                               {deformation_row("21", [](double t) { return 3 * t; })}, {"12", "13", "23", "31", "32"});
  for (const char* ij : {"11", "22", "33"}) control.rows.push_back(deformation_row(ij, [](double) { return 1.0; }));
  ControlStop loss{ControlStop::When::loss_of_ellipticity, {}, 0, "loss of ellipticity"};
  auto found = follow_control(*material, control, even_times(1, 30));
  ASSERT_TRUE(found.loses_ellipticity.has_value());
  EXPECT_EQ(found.outcome, ControlOutcome::completed);
  EXPECT_NEAR(3 * *found.loses_ellipticity, 1.05, 0.02);  // DESIGN 1: gamma ~ 1.05
  control.stops = {loss};
  found = follow_control(*material, control, even_times(1, 30));
  EXPECT_EQ(found.outcome, ControlOutcome::stopped);
  EXPECT_NEAR(found.rows.back().acoustic, 0, 0.05);
  EXPECT_NEAR(found.normal.norm(), 1, 1e-12);
}

/// A model that refuses beyond F11 = 1.2 ends the history there, with its own words.
TEST(ControlledHistory, EndsWhereTheModelRefuses) {
  static constexpr auto update = [](void*, const assay_step* step, std::size_t n, const double*, double*,
                                    double* cauchy, std::int32_t* status, double*, char* message) {
    for (std::size_t p = 0; p < n; ++p) {
      const double longer = step->F1[p];
      for (std::size_t c = 0; c < 9; ++c) cauchy[c * n + p] = 0;
      for (std::size_t c = 0; c < 9; c += 4) cauchy[c * n + p] = 1000 * (step->F1[c * n + p] - 1);
      status[p] = longer > 1.2 ? ASSAY_FAILED : ASSAY_GOOD;
      if (longer > 1.2) std::snprintf(message, ASSAY_MESSAGE_SIZE, "torn");
    }
  };
  assay_material table{};
  table.abi_major = ASSAY_ABI_MAJOR, table.struct_size = sizeof table;
  table.name = "brittle", table.version = "1", table.licence = table.doc = "test";
  table.create = [](const double*, char*) -> void* {
    static char self;
    return &self;
  };
  table.destroy = [](void*) {};
  table.update = update;
  const Material material(&table, {});
  const Control control = control_of(
      Deformation::gradient, StressMeasure::cauchy,
      {deformation_row("11", [](double t) { return 1 + t; }), stress_row("22", zero), stress_row("33", zero)},
      {"12", "13", "21", "23", "31", "32"});
  const auto found = follow_control(material, control, even_times(1, 10));
  EXPECT_EQ(found.outcome, ControlOutcome::material_failed);
  EXPECT_NE(found.reason.find("torn"), std::string::npos) << found.reason;
  EXPECT_NEAR(found.rows.back().F(0, 0), 1.2, 1e-9);
  ASSERT_TRUE(found.failure && found.failure->step);
}

/// Rows that do not fit are refused before anything is run.
TEST(ControlledHistory, RefusesRowsThatDoNotFit) {
  const auto material = builtin_material(assay_builtin_neo_hookean, elastic);
  const auto row_of = [&](const Control& control) {
    try {
      follow_control(*material, control, even_times(1, 1));
    } catch (const ControlError& error) {
      return error.row;
    }
    return -2;
  };
  Control few = along_1(zero), many = along_1(zero), twice = along_1(zero);
  few.rows.pop_back();
  many.rows.push_back(stress_row("12", zero));
  twice.rows[1] = deformation_row("11", zero);
  EXPECT_EQ(row_of(few), -1);
  EXPECT_EQ(row_of(many), -1);
  EXPECT_EQ(row_of(twice), 1);
}

/// The estimated error is above the true one, and not by far: in a strain that is solved for.
TEST(ControlledHistory, EstimatesItsError) {
  const auto material = builtin_material(assay_builtin_zener,
                                         {{"E", 1000}, {"nu", 0.3}, {"viscous_ratio", 1.5}, {"relaxation_time", 0.3}});
  const Control control = stressed_along_1([](double t) { return 300 * t * (1.5 - t); });
  const auto exact = follow_control(*material, control, even_times(1, 1), {.tolerance = 1e-13});
  for (const double tolerance : {1e-6, 1e-8, 1e-10}) {
    const auto found = follow_control(*material, control, even_times(1, 1), {.tolerance = tolerance});
    const double error = std::abs(found.rows.back().q(0, 0) - exact.rows.back().q(0, 0)) / 0.3;
    EXPECT_LT(error, 2 * found.rows.back().error) << tolerance;
  }
}

}  // namespace
}  // namespace assay::test_controlled_history
