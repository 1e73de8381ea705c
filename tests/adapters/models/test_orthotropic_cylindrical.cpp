// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/adapters/models/single_point.hpp"

namespace assay::model_tests::test_orthotropic_cylindrical {
namespace {

const std::map<std::string, double> wood = {{"E_r", 1000},  {"E_t", 2500},  {"E_z", 1600},
                                            {"nu_rt", 0.2}, {"nu_rz", 0.3}, {"nu_tz", 0.4},
                                            {"G_rt", 450},  {"G_rz", 500},  {"G_tz", 700}};

Material orthotropic(const std::map<std::string, double>& changed = {}) {
  std::map<std::string, double> parameters = changed;
  parameters.insert(wood.begin(), wood.end());
  return material_of("orthotropic_cylindrical", parameters);
}

std::vector<double> along(double angle) { return {std::cos(angle), std::sin(angle), 0}; }

/// Second Piola-Kirchhoff stress.
Tensor stress(const Material& material, const Tensor& F, const std::vector<double>& direction) {
  return F.inverse() * first_piola_kirchhoff(point_after(material, 0, 1, F, F, direction).cauchy, F);
}

TEST(OrthotropicCylindrical, EngineeringConstantsInEachAxis) {
  const Material material = orthotropic();
  const auto of = [&](const char* name) { return material.parameter(name); };
  const Tensor F = stretched_and_turned(0.9, 0.5);
  const double angle = 0.7;
  const Tensor axes = rotation_about_z(angle);
  const Tensor E = axes.transpose() * (0.5 * (F.transpose() * F - Tensor::Identity())) * axes;
  const Tensor S = axes.transpose() * stress(material, F, along(angle)) * axes;
  const double scale = largest(E);
  EXPECT_NEAR(E(0, 0), S(0, 0) / of("E_r") - of("nu_rt") / of("E_r") * S(1, 1) - of("nu_rz") / of("E_r") * S(2, 2),
              1e-13 * scale);
  EXPECT_NEAR(E(1, 1), S(1, 1) / of("E_t") - of("nu_rt") / of("E_r") * S(0, 0) - of("nu_tz") / of("E_t") * S(2, 2),
              1e-13 * scale);
  EXPECT_NEAR(E(2, 2), S(2, 2) / of("E_z") - of("nu_rz") / of("E_r") * S(0, 0) - of("nu_tz") / of("E_t") * S(1, 1),
              1e-13 * scale);
  EXPECT_NEAR(2 * E(0, 1), S(0, 1) / of("G_rt"), 1e-13 * scale);
  EXPECT_NEAR(2 * E(0, 2), S(0, 2) / of("G_rz"), 1e-13 * scale);
  EXPECT_NEAR(2 * E(1, 2), S(1, 2) / of("G_tz"), 1e-13 * scale);
  EXPECT_GT(largest(stress(material, F, along(angle + 0.1)) - axes * S * axes.transpose()), 1);
}

TEST(OrthotropicCylindrical, TurningBodyAndDirectionAboutE3TurnsTheStress) {
  const Material material = orthotropic();
  const Tensor F = stretched_and_turned(0.9, 0.5), Q = rotation_about_z(1.1);
  const Tensor plain = point_after(material, 0, 1, F, F, along(0.3)).cauchy;
  const Tensor turned = point_after(material, 0, 1, F, Q * F * Q.transpose(), along(1.4)).cauchy;
  EXPECT_LT(largest(Q.transpose() * turned * Q - plain), 1e-12 * largest(plain));
  EXPECT_LT(objectivity_error(
                material, [](double t) { return stretched_and_turned(t, 0.5); }, 0.9, 3),
            1e-13);
}

TEST(OrthotropicCylindrical, EnergyAndTangent) {
  const Material material = orthotropic();
  const Tensor F = stretched_and_turned(0.9, 0.5);
  Point point = point_after(material, 0, 1, F, F, along(0.7));
  EXPECT_EQ(point.state, along(0.7));
  EXPECT_LT(energy_error(material, F, point), 1e-10);
  EXPECT_LT(tangent_error(material, 1, F, F, point.state), 1e-6);
  EXPECT_GT(tangent_error(material, 1, F, F, point.state, 1e-4), 1e-6);
  point.state = along(0.8);
  EXPECT_GT(energy_error(material, F, point), 1e-3);
}

TEST(OrthotropicCylindrical, ClosedFormsAreTheUpdateAlongE1) {
  const Material material = orthotropic();
  for (const int baseline : {ASSAY_BASELINE_SIMPLE_SHEAR, ASSAY_BASELINE_UNIAXIAL_STRAIN}) {
    for (const double eps : {-0.6, 0.01, 1.7}) {
      const auto [value, slope] = closed_form_errors(material, baseline, eps);
      EXPECT_LT(value, 1e-12) << baseline << ' ' << eps;
      EXPECT_LT(slope, 1e-10) << baseline << ' ' << eps;
    }
  }
}

TEST(OrthotropicCylindrical, IsotropicConstantsGiveSaintVenantKirchhoff) {
  const double E = 1000, nu = 0.3, G = E / (2 * (1 + nu));
  const Material isotropic = material_of("saint_venant_kirchhoff", {{"E", E}, {"nu", nu}});
  const Material material = orthotropic({{"E_r", E},
                                         {"E_t", E},
                                         {"E_z", E},
                                         {"nu_rt", nu},
                                         {"nu_rz", nu},
                                         {"nu_tz", nu},
                                         {"G_rt", G},
                                         {"G_rz", G},
                                         {"G_tz", G}});
  const Tensor F = stretched_and_turned(0.9, 0.5);
  const Tensor expected = point_after(isotropic, 0, 1, F, F, {}).cauchy;
  EXPECT_LT(largest(point_after(material, 0, 1, F, F, along(0.7)).cauchy - expected), 1e-12 * largest(expected));
}

TEST(OrthotropicCylindrical, ConstantsThatStoreNoEnergyAreRefusedByName) {
  const auto refusal = [](const std::map<std::string, double>& changed) -> std::string {
    try {
      orthotropic(changed);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(refusal({{"nu_rt", 0.64}}).find("nu_rt^2 must be below E_r / E_t"), std::string::npos);
  EXPECT_NE(refusal({{"nu_rz", 0.8}}).find("nu_rz^2 must be below E_r / E_z"), std::string::npos);
  EXPECT_NE(refusal({{"nu_tz", 1.26}}).find("nu_tz^2 must be below E_t / E_z"), std::string::npos);
  EXPECT_NE(refusal({{"nu_rt", 0.5}, {"nu_rz", 0.5}, {"nu_tz", 0.5}}).find("2 nu_rt nu_rz nu_tz"), std::string::npos);
  EXPECT_NE(refusal({{"nu_rt", 0.48}}), "");
  EXPECT_EQ(refusal({{"nu_rt", 0.47}}), "");
}

TEST(OrthotropicCylindrical, ADirectionOutOfThePlaneFails) {
  const Material material = orthotropic();
  const Tensor F = sheared(0.1);
  EXPECT_THROW(point_after(material, 0, 1, F, F, {0, 0, 1}), std::runtime_error);
  EXPECT_THROW(point_after(material, 0, 1, F, F, {1.1, 0, 0}), std::runtime_error);
  EXPECT_NO_THROW(point_after(material, 0, 1, F, F, {-1, 0, 0}));
}

}  // namespace
}  // namespace assay::model_tests::test_orthotropic_cylindrical
