// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/adapters/models/references/elastic.hpp"
#include "tests/adapters/models/single_point.hpp"

namespace assay::model_tests::test_saint_venant_kirchhoff {
namespace {

constexpr double E = 1000, nu = 0.3;

TEST(SaintVenantKirchhoff, StressIsLinearInTheGreenStrain) {
  const Material material = material_of("saint_venant_kirchhoff", {{"E", E}, {"nu", nu}});
  const Tensor F = stretched_and_turned(0.9, 0.5), I = Tensor::Identity();
  const Tensor sigma = deformed(material, F).cauchy;
  EXPECT_LT(largest(sigma - saint_venant_kirchhoff_stress({E, nu}, F)), 1e-12 * largest(sigma));
  EXPECT_EQ(largest(deformed(material, I).cauchy), 0);
}

TEST(SaintVenantKirchhoff, EnergyTangentObjectivity) {
  const Material material = material_of("saint_venant_kirchhoff", {{"E", E}, {"nu", nu}});
  expect_hyperelastic(material);
}

TEST(SaintVenantKirchhoff, ClosedFormsAreTheUpdate) {
  const Material material = material_of("saint_venant_kirchhoff", {{"E", E}, {"nu", nu}});
  expect_closed_forms(material);
  EXPECT_GT(closed_form_errors(material, 3, 0.1).first, 1);
}

}  // namespace
}  // namespace assay::model_tests::test_saint_venant_kirchhoff
