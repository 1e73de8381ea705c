// SPDX-License-Identifier: BSD-3-Clause
// Ansys' USERMAT and LS-DYNA's user materials: they answer as the UMATs and native models of the same laws.
#include <gtest/gtest.h>

#include <cmath>

#include "adapters/builtin.hpp"
#include "adapters/foreign/foreign_table.hpp"
#include "adapters/library.hpp"
#include "harness/check/march.hpp"
#include "harness/material/checked_update.hpp"
#include "tests/adapters/foreign/vendor_doubles.hpp"

namespace assay::adapters::test_other_vendors {
namespace {

constexpr double E = 1000, nu = 0.3;  ///< of the doubles
constexpr double tolerance = 1e-9;    ///< of stresses over the largest: the same formulas, in another order

using Values = std::map<std::string, double>;

Material material_of(const ForeignModel& model, double which = 0) {
  return Material(foreign_table(model), {{"which", which}});
}

Material umat_of(Axes axes) {
  ForeignModel model = foreign_double("umat_j2");
  model.axes = axes;
  return Material(foreign_table(model), {{"E", E}, {"nu", nu}, {"yield", 10}, {"isotropic", 20}, {"kinematic", 0}});
}

Tensor stretch_and_turn(double t) {
  Tensor A;
  A << 0.05, 0.04, -0.03, 0.01, -0.03, 0.02, -0.02, 0.03, 0.02;
  return check::turn_about({1, 2, 3}, 0.9 * t) * (Tensor::Identity() + std::sin(2.5 * t) * A);
}

/// The largest difference over the largest stress, along a path that turns and yields.
double difference(const Material& a, const Material& b) {
  constexpr int steps = 40;
  std::vector<double> of_a = a.initial_state(1), of_b = b.initial_state(1);
  double largest = 0, apart = 0;
  for (int k = 0; k < steps; ++k) {
    const double t = k / 40.0, dt = 1 / 40.0;
    const Tensor F0 = stretch_and_turn(t), F1 = stretch_and_turn(t + dt);
    const assay::StepEnd end_a = assay::stepped(a, t, dt, F0, F1, of_a), end_b = assay::stepped(b, t, dt, F0, F1, of_b);
    of_a = end_a.state, of_b = end_b.state;
    largest = std::max(largest, end_b.cauchy.cwiseAbs().maxCoeff());
    apart = std::max(apart, (end_a.cauchy - end_b.cauchy).cwiseAbs().maxCoeff());
  }
  EXPECT_GT(largest, 10) << "it yields";
  return apart / largest;
}

std::string refusal_of_step(const Material& material, const Tensor& F1, double* factor = nullptr) {
  const Tensor I = Tensor::Identity();
  double rows0[9], rows1[9], cauchy[9];
  for (int c = 0; c < 9; ++c) rows0[c] = component(I, c), rows1[c] = component(F1, c);
  std::vector<double> state = material.initial_state(1), after = state;
  const UpdateReport report = material.update(0, 1, 1, rows0, rows1, state.data(), after.data(), cauchy);
  if (factor) *factor = report.dt_factor;
  return report.worst == ASSAY_GOOD ? "" : report.message;
}

Tensor tension(double stretch) {
  Tensor F = Tensor::Identity();
  F(0, 0) = stretch;
  return F;
}

class OtherVendors : public testing::Test {
 protected:
  void SetUp() override {
    if (!double_exists("usermat_j2")) GTEST_SKIP() << "no Fortran compiler";
  }
};

TEST_F(OtherVendors, PlasticityIsThatOfTheUmat) {
  EXPECT_LT(difference(material_of(usermat_double()), umat_of(Axes::corotational)), tolerance);
  EXPECT_LT(difference(material_of(usermat_double(Axes::fixed)), umat_of(Axes::fixed)), tolerance);
  EXPECT_LT(difference(material_of(lsdyna_double()), umat_of(Axes::fixed)), tolerance);
  for (const char* older : {"umat42_", "umat43_", "umat44_"})
    EXPECT_LT(difference(material_of(lsdyna_double(older)), umat_of(Axes::fixed)), tolerance) << older;
  ForeignModel turning = lsdyna_double();
  turning.axes = Axes::corotational;
  EXPECT_LT(difference(material_of(turning), umat_of(Axes::corotational)), tolerance);
}

/// A model that takes engineering shears for those of a tensor must not pass here.
TEST_F(OtherVendors, AnotherConventionOfShearsShows) {
  EXPECT_GT(difference(material_of(usermat_double(), 5), umat_of(Axes::corotational)), 0.1);
}

TEST_F(OtherVendors, NeoHookeanElasticityByFIsTheNativeModel) {
  const Material native(builtin_table("neo_hookean"), {{"E", E}, {"nu", nu}});
  EXPECT_LT(difference(material_of(usermat_double(), 6), native), tolerance);
  ForeignModel hyper = lsdyna_double();
  hyper.finite_strain = true;
  EXPECT_LT(difference(material_of(hyper, 6), native), tolerance);
}

TEST_F(OtherVendors, UnitsAreThoseOfTheModel) {
  ForeignModel mega = usermat_double();
  mega.units.stress = 1e6;
  const Tensor F = tension(1.001);
  const Tensor a =
      assay::stepped(material_of(mega), 0, 1, Tensor::Identity(), F, material_of(mega).initial_state(1)).cauchy;
  const Tensor b = assay::stepped(material_of(usermat_double()), 0, 1, Tensor::Identity(), F,
                                  material_of(usermat_double()).initial_state(1))
                       .cauchy;
  EXPECT_NEAR(a(0, 0) / b(0, 0), 1e6, 1e-6);
}

TEST_F(OtherVendors, TheTangentIsThatOfTheStress) {
  for (const Axes axes : {Axes::corotational, Axes::fixed}) {
    const Material material = material_of(usermat_double(axes));
    const auto* tangent = material.extension<assay_tangent>(ASSAY_EXTENSION_TANGENT);
    ASSERT_TRUE(tangent);
    const Tensor F0 = stretch_and_turn(0.4), F1 = stretch_and_turn(0.5);
    const std::vector<double> state =
        assay::stepped(material, 0, 1, Tensor::Identity(), F0, material.initial_state(1)).state;
    double rows0[9], rows1[9], moduli[81];
    for (int c = 0; c < 9; ++c) rows0[c] = component(F0, c), rows1[c] = component(F1, c);
    const assay_step step{0, 1, rows0, rows1};
    ASSERT_EQ(tangent->tangent(material.self(), &step, 1, state.data(), moduli), ASSAY_GOOD);
    constexpr double h = 1e-6;
    for (int column = 0; column < 9; ++column) {
      Tensor up = F1, down = F1;
      component(up, column) += h, component(down, column) -= h;
      const Tensor slope = (assay::stepped(material, 0, 1, F0, up, state).cauchy -
                            assay::stepped(material, 0, 1, F0, down, state).cauchy) /
                           (2 * h);
      for (int row = 0; row < 9; ++row) EXPECT_NEAR(moduli[9 * row + column], component(slope, row), 1e-5 * E);
    }
  }
}

TEST_F(OtherVendors, FourComponentsServeThePlane) {
  ForeignModel plane = usermat_double();
  plane.components = {4};
  Tensor F = tension(1.01);
  F(0, 1) = 0.02;
  const Material of_plane = material_of(plane), whole = material_of(usermat_double());
  const Tensor I = Tensor::Identity();
  EXPECT_LT((assay::stepped(of_plane, 0, 1, I, F, of_plane.initial_state(1)).cauchy -
             assay::stepped(whole, 0, 1, I, F, whole.initial_state(1)).cauchy)
                .norm(),
            tolerance);
  F(0, 2) = 0.01;
  EXPECT_NE(refusal_of_step(of_plane, F).find("plane strain alone"), std::string::npos);
}

TEST_F(OtherVendors, WhatTheModelRefusesAndOverrunsIsTold) {
  double factor = 1;
  EXPECT_NE(refusal_of_step(material_of(usermat_double(), 1), tension(1.3), &factor).find("keycut = 1"),
            std::string::npos);
  EXPECT_EQ(factor, 0.5);
  EXPECT_NE(refusal_of_step(material_of(usermat_double(), 2), tension(1.3), &factor).find("cutFactor = 0.2"),
            std::string::npos);
  EXPECT_EQ(factor, 0.2);
  EXPECT_EQ(refusal_of_step(material_of(usermat_double(), 1), tension(1.05)), "");
  EXPECT_NE(refusal_of_step(material_of(usermat_double(), 3), tension(1.05)).find("writes past ustatev, which has 1"),
            std::string::npos);
  EXPECT_NE(refusal_of_step(material_of(lsdyna_double(), 1), tension(1.3), &factor).find("reject"), std::string::npos);
  EXPECT_EQ(factor, 0.5);
  EXPECT_NE(refusal_of_step(material_of(lsdyna_double(), 2), tension(1.3), &factor).find("failel"), std::string::npos);
  EXPECT_EQ(factor, 1) << "no shorter step helps";
  for (const bool hyper : {false, true}) {
    ForeignModel model = lsdyna_double();
    model.finite_strain = hyper;
    EXPECT_NE(refusal_of_step(material_of(model, 3), tension(1.05)).find("writes past hsv, which has 1"),
              std::string::npos)
        << hyper;
  }
}

TEST_F(OtherVendors, AWrongSymbolIsNamed) {
  ForeignModel model = usermat_double();
  model.symbol = "usermat3d_";
  try {
    foreign_table(model);
    FAIL();
  } catch (const ModelRefused& refused) {
    EXPECT_EQ(refused.key(), "symbol");
    EXPECT_NE(refused.known().find("usermat_"), std::string::npos);
  }
}

}  // namespace
}  // namespace assay::adapters::test_other_vendors
