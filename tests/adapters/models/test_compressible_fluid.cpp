// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/adapters/models/references/elastic.hpp"
#include "tests/adapters/models/single_point.hpp"

namespace assay::model_tests::test_compressible_fluid {
namespace {

constexpr double modulus = 2000;

Material fluid(double viscosity, double bulk_viscosity, double exponent) {
  return material_of("compressible_fluid", {{"bulk_modulus", modulus},
                                            {"viscosity", viscosity},
                                            {"bulk_viscosity", bulk_viscosity},
                                            {"exponent", exponent}});
}

Tensor moving(double t) { return stretched_and_turned(t, 0.5); }

Tensor exact(double t, double viscosity, double bulk_viscosity, double exponent) {
  return fluid_stress({modulus, viscosity, bulk_viscosity, exponent}, moving(t), velocity_gradient(moving, t));
}

Tensor one_step(const Material& material, double t, double dt) {
  return point_after(material, t - dt, dt, moving(t - dt), moving(t), {}).cauchy;
}

TEST(CompressibleFluid, ConvergesToTheNewtonianStressAtFirstOrder) {
  for (const double exponent : {1.0, 7.0}) {
    const Material material = fluid(300, 200, exponent);
    const Tensor sigma = exact(0.8, 300, 200, exponent);
    double error[2];
    for (int k = 0; k < 2; ++k) error[k] = largest(one_step(material, 0.8, k ? 1e-4 : 2e-4) - sigma) / largest(sigma);
    EXPECT_LT(error[1], 2e-4);
    EXPECT_NEAR(error[0] / error[1], 2, 0.01);
    // The error is a power series of the step: one extrapolation gains an order.
    const Tensor better = 2 * one_step(material, 0.8, 1e-4) - one_step(material, 0.8, 2e-4);
    EXPECT_LT(largest(better - sigma) / largest(sigma), 1e-6);
    EXPECT_GT(largest(better - exact(0.8, 301, 200, exponent)) / largest(sigma), 1e-5);
  }
}

TEST(CompressibleFluid, ATurningFluidFeelsNoViscosity) {
  const Material material = fluid(300, 200, 1);
  const Tensor I = Tensor::Identity(), turn = Eigen::AngleAxisd(0.9, Vector3(1, 2, 3).normalized()).toRotationMatrix();
  EXPECT_LT(largest(point_after(material, 0, 1e-3, I, turn, {}).cauchy), 1e-8);
  EXPECT_EQ(largest(point_after(material, 0, 1e-3, I, I, {}).cauchy), 0);
  EXPECT_LT(objectivity_error(material, moving, 0.9, 50), 1e-11);
}

TEST(CompressibleFluid, EnergyTangentAndSound) {
  for (const double exponent : {1.0, 7.0}) {
    const Material still = fluid(0, 0, exponent), viscous = fluid(300, 200, exponent);
    const Tensor F = moving(0.8);
    Point point = point_after(still, 0, 1, F, F, {});
    EXPECT_LT(energy_error(still, F, point), 1e-9);
    EXPECT_LT(tangent_error(still, 1, F, F, {}), 1e-6);
    EXPECT_LT(tangent_error(viscous, 0.02, moving(0.78), F, {}), 1e-6);
    EXPECT_GT(tangent_error(viscous, 0.02, moving(0.78), F, {}, 1e-4), 1e-6);
    point.cauchy(0, 0) *= 1.0001;
    EXPECT_GT(energy_error(still, F, point), 1e-6);

    const auto* sound = still.extension<assay_wave_speed>(ASSAY_EXTENSION_WAVE_SPEED);
    const auto f = components_of(F), cauchy = components_of(point.cauchy);
    double speed = 0;
    ASSERT_EQ(sound->wave_speed(still.self(), 1000, 1, f.data(), cauchy.data(), nullptr, &speed), ASSAY_GOOD);
    const double J = F.determinant(), h = 1e-6;  // c^2 = dp/drho, rho = 1000 / J
    const auto pressure = [&](double rho) { return modulus / exponent * (std::pow(rho / 1000, exponent) - 1); };
    const double rho = 1000 / J;
    EXPECT_NEAR(speed * speed, (pressure(rho * (1 + h)) - pressure(rho * (1 - h))) / (2 * h * rho), 1e-6);
  }
}

TEST(CompressibleFluid, ClosedFormsWithoutViscosityOnly) {
  for (const double exponent : {1.0, 7.0}) {
    for (const double eps : {-0.4, 0.01, 0.7}) {
      const auto [value, slope] = closed_form_errors(fluid(0, 0, exponent), ASSAY_BASELINE_UNIAXIAL_STRAIN, eps);
      EXPECT_LT(value, 1e-12);
      EXPECT_LT(slope, 1e-10);
    }
  }
  EXPECT_GT(closed_form_errors(fluid(1, 0, 1), ASSAY_BASELINE_UNIAXIAL_STRAIN, 0.1).first, 1);
}

}  // namespace
}  // namespace assay::model_tests::test_compressible_fluid
