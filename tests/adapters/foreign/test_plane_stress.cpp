// SPDX-License-Identifier: BSD-3-Clause
// UMATs of plane stress (NTENS = 3): the thickness of the host, and what does not depend on it.
#include <gtest/gtest.h>

#include <cmath>

#include "adapters/foreign/foreign_state.hpp"
#include "adapters/foreign/foreign_table.hpp"
#include "adapters/foreign/membrane.hpp"
#include "harness/control/controlled_history.hpp"
#include "harness/material/checked_update.hpp"
#include "tests/adapters/foreign/foreign_doubles.hpp"

namespace assay::adapters::test_plane_stress {
namespace {

constexpr double E = 1000, nu = 0.3;
constexpr double tolerance = 1e-9;  ///< of stresses over the largest: both are solved to 1e-11

ForeignModel plane_stress(double thickness, bool finite_strain = false) {
  ForeignModel model = foreign_double("umat_plane_stress");
  model.properties.push_back({"law", "", "", 1});
  model.components = {3};
  model.thickness = thickness;
  model.finite_strain = finite_strain;
  return model;
}

Material material_of(const ForeignModel& model, double law) {
  return Material(foreign_table(model), {{"E", E}, {"nu", nu}, {"law", law}});
}

Tensor plane_F(double F11, double F12, double F21, double F22, double F33) {
  Tensor F;
  F << F11, F12, 0, F21, F22, 0, 0, 0, F33;
  return F;
}

assay::StepEnd step_of(const Material& material, const Tensor& F0, const Tensor& F1) {
  return assay::stepped(material, 0, 1, F0, F1, material.initial_state(1));
}

class PlaneStressUmat : public testing::Test {
 protected:
  void SetUp() override {
    if (!double_exists("umat_plane_stress")) GTEST_SKIP() << "no Fortran compiler";
  }
};

/// Incompressible neo-Hookean: sigma11 = mu (l^2 - 1/l) where face 2 is free, with l2 = l3 = l^-1/2.
TEST_F(PlaneStressUmat, TensionOfRubberIsThatOfTheClosedForm) {
  const Material rubber = material_of(plane_stress(0.5, true), 2);
  const double mu = E / (2 * (1 + nu));
  for (const double l : {0.7, 1.4, 3.0}) {
    const Tensor F = plane_F(l, 0, 0, 1 / std::sqrt(l), 1 / std::sqrt(l));
    const Tensor cauchy = step_of(rubber, Tensor::Identity(), F).cauchy;
    EXPECT_NEAR(cauchy(0, 0), mu * (l * l - 1 / l), tolerance * mu * l * l);
    EXPECT_NEAR(cauchy(1, 1), 0, tolerance * mu);
    EXPECT_EQ(cauchy.col(2), Vector3::Zero());
  }
}

TEST_F(PlaneStressUmat, TheFirstPiolaKirchhoffStressDoesNotDependOnAHeldThickness) {
  for (const double thickness : {0.0, 0.3, 0.5, -0.2}) {
    const Material material = material_of(plane_stress(thickness), 1);
    Tensor P[2], cauchy[2];
    const Tensor own = with_thickness(plane_stress(thickness), plane_F(1.2, 0.3, -0.1, 0.9, 1));
    const double F33[] = {own(2, 2), 1.7};
    for (int k = 0; k < 2; ++k) {
      Tensor F = own;
      F(2, 2) = F33[k];
      cauchy[k] = step_of(material, Tensor::Identity(), F).cauchy;
      P[k] = F.determinant() * cauchy[k] * F.inverse().transpose();
    }
    EXPECT_LT((P[0] - P[1]).norm(), 1e-12 * P[0].norm()) << thickness;
    EXPECT_NEAR(cauchy[1](0, 0) / cauchy[0](0, 0), own(2, 2) / 1.7, 1e-12) << thickness;
  }
}

/// ln F33 = -nu / (1 - nu) (e11 + e22), the strain of an elastic sheet.
TEST(PlaneStress, TheThicknessFollowsTheArea) {
  ForeignModel model;
  model.thickness = 0.25;
  const Tensor F = with_thickness(model, plane_F(1.3, 0.2, 0.1, 0.8, 5));
  EXPECT_NEAR(std::log(F(2, 2)), -0.25 / 0.75 * std::log(1.3 * 0.8 - 0.2 * 0.1), 1e-15);
  constexpr double h = 1e-6;
  const Tensor rate = plane_F(0.3, -0.7, 0.2, 0.5, 0.9);
  const Tensor difference = (with_thickness(model, F + h * rate) - with_thickness(model, F - h * rate)) / (2 * h);
  EXPECT_LT((rate_with_thickness(model, F, rate) - difference).norm(), 1e-9);
  const double by_difference =
      std::log(membrane_factor(model, F + h * rate) / membrane_factor(model, F - h * rate)) / (2 * h);
  EXPECT_NEAR(membrane_factor_rate(model, F, rate), by_difference, 1e-9);
}

/// By differences of the stress, at a thickness that is not the host's.
TEST_F(PlaneStressUmat, TheTangentIsThatOfTheStress) {
  for (const bool finite : {false, true}) {
    const ForeignModel model = plane_stress(finite ? 0.5 : 0.3, finite);
    const Material material = material_of(model, finite ? 2 : 1);
    const auto* tangent = material.extension<assay_tangent>(ASSAY_EXTENSION_TANGENT);
    ASSERT_TRUE(tangent);
    const Tensor F0 = plane_F(1.05, 0.1, 0, 0.97, 1.02), F1 = plane_F(1.2, 0.3, -0.1, 0.9, 1.1);
    const std::vector<double> state = step_of(material, Tensor::Identity(), F0).state;
    double moduli[81];
    double rows0[9], rows1[9];
    for (int c = 0; c < 9; ++c) rows0[c] = component(F0, c), rows1[c] = component(F1, c);
    const assay_step step{0, 1, rows0, rows1};
    ASSERT_EQ(tangent->tangent(material.self(), &step, 1, state.data(), moduli), ASSAY_GOOD);
    constexpr double h = 1e-5;
    for (const int column : {0, 1, 3, 4, 8}) {
      Tensor up = F1, down = F1;
      component(up, column) += h, component(down, column) -= h;
      const Tensor slope = (assay::stepped(material, 0, 1, F0, up, state).cauchy -
                            assay::stepped(material, 0, 1, F0, down, state).cauchy) /
                           (2 * h);
      for (int row = 0; row < 9; ++row)
        EXPECT_NEAR(moduli[9 * row + column], component(slope, row), 1e-6 * E) << finite << " " << row << " " << column;
    }
  }
}

TEST_F(PlaneStressUmat, WhatItMustNotDoIsRefused) {
  const auto message = [](double law, const Tensor& F) -> std::string {
    try {
      step_of(material_of(plane_stress(0.3), law), Tensor::Identity(), F);
      return "nothing";
    } catch (const MaterialFailure& failure) {
      return failure.what();
    }
  };
  const Tensor small = plane_F(1.05, 0, 0, 1, 1);
  EXPECT_NE(message(3, small).find("writes past STRESS, which has 3 components"), std::string::npos);
  EXPECT_NE(message(4, plane_F(1.3, 0, 0, 1, 1)).find("PNEWDT = 0.25"), std::string::npos);
  EXPECT_EQ(message(4, small), "nothing");
  Tensor sheared = small;
  sheared(0, 2) = 0.1;
  EXPECT_NE(message(1, sheared).find("plane stress alone (NTENS = 3)"), std::string::npos);
  const std::vector<double> pressed{-1, 0, 0, 0, -1, 0, 0, 0, -1};
  EXPECT_THROW((void)material_of(plane_stress(0.3), 1).initial_state(1, pressed), std::runtime_error);
}

/// An elastic sheet, and a body of three dimensions whose face 3 is free: nu is the ratio of both.
TEST_F(PlaneStressUmat, IsTheBodyOfThreeDimensionsWithAFreeFace) {
  ForeignModel whole = foreign_double("umat_j2");
  const Material body(foreign_table(whole), {{"E", E}, {"nu", nu}, {"yield", 1e9}, {"isotropic", 0}, {"kinematic", 0}});
  const Material sheet = material_of(plane_stress(nu), 1);
  const auto control_of = [](bool is_sheet) {
    assay::Control control{.deformation = Deformation::logarithmic_strain,
                           .stress = StressMeasure::cauchy,
                           .rows = {},
                           .knots = {0, 0.5, 1}};
    const auto row = [&](int i, int j, double (*value)(double)) {
      ControlRow made;
      made.deformation(i, j) = 1;
      made.value = [value](double t, bool) { return value(t); };
      control.rows.push_back(std::move(made));
    };
    row(0, 0, [](double t) { return 0.4 * t * (1 - 0.5 * t); });
    row(1, 1, [](double t) { return -0.2 * t * t; });
    row(0, 1, [](double t) { return 0.2 * t; });
    row(0, 2, [](double) { return 0.0; });
    row(1, 2, [](double) { return 0.0; });
    row(2, 2, [](double) { return 0.0; });
    ControlRow& last = control.rows.back();
    if (is_sheet) last.deformation(0, 0) = last.deformation(1, 1) = nu / (1 - nu);
    if (!is_sheet) last.deformation.setZero(), last.stress(2, 2) = 1;
    return control;
  };
  const std::vector<double> times{0, 0.25, 0.5, 0.75, 1};
  const ControlledHistory a = follow_control(body, control_of(false), times);
  const ControlledHistory b = follow_control(sheet, control_of(true), times);
  ASSERT_EQ(a.outcome, ControlOutcome::completed) << a.reason;
  ASSERT_EQ(b.outcome, ControlOutcome::completed) << b.reason;
  ASSERT_EQ(a.rows.size(), b.rows.size());
  const double largest = a.rows.back().s.norm();
  for (std::size_t k = 0; k < a.rows.size(); ++k) {
    EXPECT_LT((a.rows[k].s - b.rows[k].s).norm(), tolerance * largest) << k;
    EXPECT_LT((a.rows[k].F - b.rows[k].F).norm(), tolerance) << k;
    EXPECT_NEAR(a.rows[k].work, b.rows[k].work, tolerance * largest) << k;
  }
}

}  // namespace
}  // namespace assay::adapters::test_plane_stress
