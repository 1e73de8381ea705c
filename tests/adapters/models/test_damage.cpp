// SPDX-License-Identifier: BSD-3-Clause
// damage against its definition evaluated on a fine history.
#include <gtest/gtest.h>

#include "tests/adapters/models/references/elastic.hpp"
#include "tests/adapters/models/single_point.hpp"

namespace assay::model_tests::test_damage {
namespace {

constexpr double kappa_0 = 2;
constexpr Damage constants{1000, 0.3, kappa_0, 15, 0.9};

Material damage() {
  return material_of("damage", {{"E", constants.E},
                                {"nu", constants.nu},
                                {"kappa_0", constants.kappa_0},
                                {"kappa_f", constants.kappa_f},
                                {"D_max", constants.D_max}});
}

Tensor shear_cycle(double t) { return sheared(0.5 * std::sin(0.5 * std::numbers::pi * t)); }
Tensor turning(double t) { return stretched_and_turned(t, 0.5); }

Tensor exact(const Path& F, double end) { return damage_stress(constants, {F, {}, end}, 20000); }

TEST(Damage, IsItsDefinitionThroughLoadingUnloadingAndReversal) {
  const Material material = damage();
  for (const Path& F : {Path(shear_cycle), Path(turning)}) {
    for (const double end : {0.1, 0.7, 1.0, 1.3, 2.0 - 1e-3}) {
      if (F(end).determinant() < 0.05) continue;
      const Tensor expected = exact(F, end);
      const Point found = march(material, F, 0, end, 400, at_rest(material));
      EXPECT_LT(largest(found.cauchy - expected), 1e-4 * largest(expected)) << end;
    }
  }
  Tensor planted = exact(shear_cycle, 1.3);
  planted *= 1.001;
  EXPECT_GT(largest(march(material, shear_cycle, 0, 1.3, 400, at_rest(material)).cauchy - planted),
            1e-4 * largest(planted));
}

TEST(Damage, LoadingIsExactInOneStepAndSoftens) {
  const Material material = damage();
  double peak = 0, last = 0;
  for (const double gamma : {0.05, 0.1, 0.2, 0.3, 0.5, 0.7}) {
    const auto F = [gamma](double t) { return sheared(gamma * t); };
    const Point found = march(material, F, 0, 1, 1, at_rest(material));
    EXPECT_LT(largest(found.cauchy - exact(F, 1)), 1e-12 * largest(found.cauchy)) << gamma;
    last = found.cauchy(0, 1);
    peak = std::max(peak, last);
  }
  EXPECT_LT(last, 0.9 * peak);
}

TEST(Damage, KappaKeepsItsBitsUntilTheEnergyExceedsIt) {
  const Material material = damage();
  const Point rest = at_rest(material);
  EXPECT_EQ(rest.state[0], kappa_0);
  EXPECT_EQ(point_after(material, 0, 1, Tensor::Identity(), sheared(0.05), rest.state).state, rest.state);
  const Point loaded = point_after(material, 0, 1, Tensor::Identity(), sheared(0.5), rest.state);
  EXPECT_EQ(loaded.state[0], undamaged_energy(constants, sheared(0.5)));
  EXPECT_EQ(point_after(material, 1, 1, sheared(0.5), sheared(0.49), loaded.state).state, loaded.state);
}

TEST(Damage, RateIntegratesToTheUpdate) {
  const Material material = damage();
  const Point begun = march(material, shear_cycle, 0, 0.4, 1, at_rest(material));
  ASSERT_GT(begun.state[0], kappa_0);
  for (const auto& [from, to] : {std::pair{0.4, 0.95}, std::pair{0.95, 0.4}}) {  // loading; back again along the path
    const auto F = [from = from, to = to](double t) { return shear_cycle(from + (to - from) * t); };
    const Point start = march(material, shear_cycle, 0, from, 1, at_rest(material));
    const Point found = integrate_rate(material, F, start, 0, 1);
    const Point expected = march(material, F, 0, 1, 1, start);
    EXPECT_LT(largest(found.cauchy - expected.cauchy), 1e-9 * largest(expected.cauchy));
    EXPECT_NEAR(found.state[0], expected.state[0], 1e-9);
  }
}

TEST(Damage, TangentEnergyObjectivity) {
  const Material material = damage();
  const Point damaged = march(material, turning, 0, 0.8, 20, at_rest(material));
  ASSERT_GT(damaged.state[0], 2 * kappa_0);
  for (const double next : {0.83, 0.7}) {  // growing, unloading
    EXPECT_LT(tangent_error(material, 0.03, turning(0.8), turning(next), damaged.state), 1e-6);
    EXPECT_GT(tangent_error(material, 0.03, turning(0.8), turning(next), damaged.state, 1e-4), 1e-6);
  }
  EXPECT_LT(energy_error(material, turning(0.8), damaged), 1e-9);
  Point planted = damaged;
  planted.state[0] *= 1.001;
  EXPECT_GT(energy_error(material, turning(0.8), planted), 1e-6);
  EXPECT_LT(objectivity_error(material, turning, 0.9, 20), 1e-12);
}

}  // namespace
}  // namespace assay::model_tests::test_damage
