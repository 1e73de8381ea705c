// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/adapters/models/references/elastic.hpp"
#include "tests/adapters/models/single_point.hpp"

namespace assay::model_tests {
namespace {

constexpr double E = 1000, nu = 0.3;

Point deformed(const Material& material, const Tensor& F) {
  return stepped(material, 0, 1, Tensor::Identity(), F, material.initial_state(1));
}

TEST(SaintVenantKirchhoff, StressIsLinearInTheGreenStrain) {
  const Material material = material_of("saint_venant_kirchhoff", {{"E", E}, {"nu", nu}});
  const Tensor F = stretched_and_turned(0.9, 0.5), I = Tensor::Identity();
  const Tensor sigma = deformed(material, F).cauchy;
  EXPECT_LT(largest(sigma - saint_venant_kirchhoff_stress({E, nu}, F)), 1e-12 * largest(sigma));
  EXPECT_EQ(largest(deformed(material, I).cauchy), 0);
}

TEST(SaintVenantKirchhoff, EnergyTangentObjectivity) {
  const Material material = material_of("saint_venant_kirchhoff", {{"E", E}, {"nu", nu}});
  const Tensor F = stretched_and_turned(0.9, 0.5);
  Point point = deformed(material, F);
  EXPECT_LT(energy_error(material, F, point), 1e-10);
  EXPECT_LT(tangent_error(material, 1, F, F, {}), 1e-6);
  EXPECT_GT(tangent_error(material, 1, F, F, {}, 1e-4), 1e-6);
  EXPECT_LT(objectivity_error(
                material, [](double t) { return stretched_and_turned(t, 0.5); }, 0.9, 3),
            1e-13);
  point.cauchy(0, 1) *= 1.0001;
  EXPECT_GT(energy_error(material, F, point), 1e-7);
}

TEST(SaintVenantKirchhoff, ClosedFormsAreTheUpdate) {
  const Material material = material_of("saint_venant_kirchhoff", {{"E", E}, {"nu", nu}});
  for (const int baseline : {ASSAY_BASELINE_SIMPLE_SHEAR, ASSAY_BASELINE_UNIAXIAL_STRAIN}) {
    for (const double eps : {-0.6, 0.01, 1.7}) {
      const auto [value, slope] = closed_form_errors(material, baseline, eps);
      EXPECT_LT(value, 1e-12) << baseline << ' ' << eps;
      EXPECT_LT(slope, 1e-10) << baseline << ' ' << eps;
    }
  }
  EXPECT_GT(closed_form_errors(material, 3, 0.1).first, 1);
}

}  // namespace
}  // namespace assay::model_tests
