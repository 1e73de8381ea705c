// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/adapters/models/single_point.hpp"

namespace assay::model_tests::test_mooney_rivlin {
namespace {

constexpr double c10 = 120, c01 = 70, kappa = 900;

Material mooney_rivlin() { return material_of("mooney_rivlin", {{"c10", c10}, {"c01", c01}, {"bulk_modulus", kappa}}); }

/// Principal stresses J sigma_i = l_i dW/dl_i of W(l_1, l_2, l_3), by differences.
TEST(MooneyRivlin, PrincipalStressesAreThoseOfTheEnergyInStretches) {
  const auto W = [](double a, double b, double c) {
    const double J = a * b * c, I1 = a * a + b * b + c * c, I2 = a * a * b * b + b * b * c * c + c * c * a * a;
    return c10 * (I1 * std::pow(J, -2.0 / 3) - 3) + c01 * (I2 * std::pow(J, -4.0 / 3) - 3) +
           0.5 * kappa * std::log(J) * std::log(J);
  };
  const double a = 1.4, b = 0.8, c = 1.1, h = 1e-5;
  const Tensor turn = Eigen::AngleAxisd(0.8, Vector3(1, 2, 3).normalized()).toRotationMatrix();
  const Tensor F = turn * Vector3(a, b, c).asDiagonal();
  const Tensor sigma = turn.transpose() * deformed(mooney_rivlin(), F).cauchy * turn;
  EXPECT_NEAR(sigma(0, 0) * b * c, (W(a + h, b, c) - W(a - h, b, c)) / (2 * h), 1e-5);
  EXPECT_NEAR(sigma(1, 1) * a * c, (W(a, b + h, c) - W(a, b - h, c)) / (2 * h), 1e-5);
  EXPECT_NEAR(sigma(2, 2) * a * b, (W(a, b, c + h) - W(a, b, c - h)) / (2 * h), 1e-5);
  EXPECT_NEAR(sigma(0, 1), 0, 1e-11);
}

TEST(MooneyRivlin, SmallStrainModuliAreThoseOfTheDocumentation) {
  const Material material = mooney_rivlin();
  EXPECT_EQ(largest(deformed(material, Tensor::Identity()).cauchy), 0);
  EXPECT_NEAR(deformed(material, sheared(1e-6)).cauchy(0, 1) / 1e-6, 2 * (c10 + c01), 1e-6);
  EXPECT_NEAR(deformed(material, Tensor((1 + 1e-7) * Tensor::Identity())).cauchy(0, 0) / 3e-7, kappa, 1e-3);
}

TEST(MooneyRivlin, EnergyTangentObjectivity) {
  const Material material = mooney_rivlin();
  expect_hyperelastic(material);
}

TEST(MooneyRivlin, ClosedFormsAreTheUpdate) {
  const Material material = mooney_rivlin();
  expect_closed_forms(material);
  EXPECT_GT(closed_form_errors(material, ASSAY_BASELINE_UNIAXIAL_STRAIN, -1.1).first, 1);  // turned inside out
}

}  // namespace
}  // namespace assay::model_tests::test_mooney_rivlin
