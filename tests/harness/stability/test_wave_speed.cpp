// SPDX-License-Identifier: BSD-3-Clause
#include "harness/stability/wave_speed.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "harness/material/material_failure.hpp"
#include "harness/motion/kinds/homogeneous.hpp"
#include "harness/motion/kinds/vortex.hpp"
#include "tests/harness/elastic_material.hpp"
#include "tests/harness/jaumann_material.hpp"

namespace assay::test_wave_speed {
namespace {

/// The probe's directions lie a few degrees apart; c is stationary there.
constexpr double direction_error = 0.02;

double own_wave(const Material& material, const Tensor& F, double density) {
  double f[9], cauchy[9] = {}, speed = 0;
  for (int c = 0; c < 9; ++c) f[c] = component(F, c);
  material.extension<assay_wave_speed>(ASSAY_EXTENSION_WAVE_SPEED)
      ->wave_speed(material.self(), density, 1, f, cauchy, nullptr, &speed);
  return speed;
}

TEST(WaveSpeed, AtRestIsThatOfLinearElasticity) {
  const double E = 2e5, nu = 0.2, density = 1300;
  const double lambda = E * nu / ((1 + nu) * (1 - 2 * nu)), mu = E / (2 * (1 + nu));
  const double expected = std::sqrt((lambda + 2 * mu) / density);
  const auto material = elastic_material(E, nu);
  EXPECT_NEAR(own_wave(*material, Tensor::Identity(), density), expected, 1e-12 * expected);
  const auto A = probe_tangent_modulus(*material, 0, 1e-3, Tensor::Identity(), {});
  EXPECT_NEAR(fastest_wave(A, Tensor::Identity(), density), expected, 1e-6 * expected);
}

TEST(WaveSpeed, ProbeAndMaterialAgreeAtLargeDeformation) {
  const auto material = elastic_material();
  Tensor F;
  F << 1.3, 0.4, -0.2, 2.1, 1.1, 0.3, 0.1, -0.5, 0.8;
  ASSERT_GT(F.determinant(), 0);
  const auto A = probe_tangent_modulus(*material, 0, 1e-3, F, {});
  // the material's formula is an upper bound over polarisations along the largest stretch: near, and never below
  const double own = own_wave(*material, F, 1000), probed = fastest_wave(A, F, 1000);
  EXPECT_GE(own, probed * (1 - direction_error));
  EXPECT_LE(own, probed * 1.25);
}

TEST(WaveSpeed, TangentModulusIsTheDerivativeOfThePiolaStress) {
  Tensor F;
  F << 1.1, 0.2, 0, -0.3, 0.9, 0.1, 0, 0.05, 1.2;
  const double mu = 1e3 / 2.6, lambda = 1e3 * 0.3 / (1.3 * 0.4);
  const auto A = probe_tangent_modulus(*elastic_material(), 0, 1e-3, F, {});
  const Tensor G = F.inverse();
  for (int i = 0; i < 3; ++i) {
    for (int J = 0; J < 3; ++J) {
      for (int k = 0; k < 3; ++k) {
        for (int L = 0; L < 3; ++L) {
          const double exact = mu * (i == k && J == L) + lambda * G(J, i) * G(L, k) +
                               (mu - lambda * std::log(F.determinant())) * G(L, i) * G(J, k);
          EXPECT_NEAR(A(3 * i + J, 3 * k + L), exact, 1e-5 * mu);
        }
      }
    }
  }
}

TEST(WaveSpeed, OnThePathIsItsLargest) {
  const Vortex vortex;
  const double c = fastest_wave_on_path(*elastic_material(), vortex.baseline(), 1000, 1);
  const Path path = vortex.baseline();
  EXPECT_NEAR(c, own_wave(*elastic_material(), path.deformation_gradient(path.parameter.lower, 0.5), 1000), 1e-12 * c);
  EXPECT_GT(c, 3 * own_wave(*elastic_material(), Tensor::Identity(), 1000));  // stretch about 7
}

/// rho0 c^2 = mu + (lambda + mu) Lambda^2 by reference lengths, mu Lambda^2 + lambda + mu by current ones: J = 1.
TEST(WaveSpeed, AcrossTheReferenceConfigurationIsThatOfTheThinnedBody) {
  const Vortex vortex;
  const Path path = vortex.baseline();
  const double density = 1000, gamma = path.deformation_gradient(path.parameter.lower, 0.5)(1, 0);
  const double stretch = std::abs(gamma) / 2 + std::sqrt(1 + gamma * gamma / 4);
  ASSERT_GT(stretch, 7);
  for (const double nu : {0.3, 0.499}) {
    const double mu = 1e3 / (2 * (1 + nu)), lambda = 2 * mu * nu / (1 - 2 * nu), square = stretch * stretch;
    const auto material = elastic_material(1e3, nu);
    const double current = fastest_wave_on_path(*material, path, density, 1);
    const double reference = fastest_wave_on_path(*material, path, density, 1, WaveFrame::reference);
    EXPECT_NEAR(current, std::sqrt((mu * square + lambda + mu) / density), direction_error * current) << nu;
    EXPECT_NEAR(reference, std::sqrt((mu + (lambda + mu) * square) / density), direction_error * reference) << nu;
  }
}

TEST(WaveSpeed, IsProbedWhereTheMaterialGivesNone) {
  const Vortex vortex{0.75, 1.25, 2, {Amplitude::Type::sine, 0.01, 1.0}};
  const double mu = 1e3 / 2.6, lambda = 1e3 * 0.3 / (1.3 * 0.4), density = 700;
  const double c = fastest_wave_on_path(*jaumann_material(), vortex.baseline(), density, 1);
  EXPECT_NEAR(c, std::sqrt((lambda + 2 * mu) / density), 0.05 * c);
}

/// The elastic model with another wave speed.
Material material_with_wave_speed(double speed) {
  static double offered;
  offered = speed;
  static const assay_wave_speed odd{
      sizeof(assay_wave_speed),
      [](void*, double, std::size_t n, const double*, const double*, const double*, double* c) -> std::int32_t {
        std::fill_n(c, n, offered);
        return ASSAY_GOOD;
      }};
  static const assay_material table = [] {
    assay_material t = elastic_material()->table();
    t.extension = [](const char* id) -> const void* {
      return std::string(id) == ASSAY_EXTENSION_WAVE_SPEED ? &odd : nullptr;
    };
    t.extension_of = nullptr;
    return t;
  }();
  return Material(&table, {{"E", 1e3}, {"nu", 0.3}});
}

TEST(WaveSpeed, IsNotTrusted) {
  const Path path = Vortex{}.baseline();
  for (const double bad : {std::nan(""), -1.0, HUGE_VAL}) {
    EXPECT_THROW(fastest_wave_on_path(material_with_wave_speed(bad), path, 1000, 1), MaterialFailure) << bad;
  }
  const double probed = fastest_wave_on_path(material_with_wave_speed(0), path, 1000, 1);
  const double own = fastest_wave_on_path(*elastic_material(), path, 1000, 1);
  EXPECT_NEAR(probed, own, direction_error * own) << "one that is 0 everywhere is not taken";
  EXPECT_EQ(fastest_wave_on_path(material_with_wave_speed(3), path, 1000, 1), 3);
}

}  // namespace
}  // namespace assay::test_wave_speed
