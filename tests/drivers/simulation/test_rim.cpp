// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/warnings.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "harness/motion/kinds/vortex.hpp"
#include "tests/drivers/quiet_run.hpp"
#include "tests/drivers/scratch_folder.hpp"
#include "tests/harness/builtin_material.hpp"

namespace assay::drivers::test_rim {
namespace {

TEST(Rim, ZonesEndWhereXiPassesAFront) {
  const Vortex vortex;
  const double fronts[] = {-1, 0.5};
  const auto zones = zones_beyond(vortex, fronts);
  ASSERT_EQ(zones.size(), 2u);  // xi > 0 on the inner half, < 0 on the outer one
  for (const double R : {zones[0].lower, zones[0].upper}) EXPECT_NEAR(vortex.profile(R).xi, 0.5, 1e-9);
  for (const double R : {zones[1].lower, zones[1].upper}) EXPECT_NEAR(vortex.profile(R).xi, -1, 1e-9);
  EXPECT_LT(zones[0].upper, zones[1].lower);
}

TEST(Rim, FrontsFurtherOutDoNotCutAZone) {
  const double fronts[] = {0.5, 1.5};
  const auto zones = zones_beyond(Vortex{}, fronts);
  ASSERT_EQ(zones.size(), 1u);
  for (const double R : {zones[0].lower, zones[0].upper}) EXPECT_NEAR(Vortex{}.profile(R).xi, 0.5, 1e-9);
}

TEST(Rim, FrontsBeyondThePeakLeaveNoZone) {
  const double fronts[] = {-50, 50};
  EXPECT_TRUE(zones_beyond(Vortex{}, fronts).empty());
}

TEST(Rim, ASentenceOnlyBelowTwoCells) {
  EXPECT_FALSE(narrow_rim_sentence({0.1, 1.99}, {}).empty());
  EXPECT_NE(narrow_rim_sentence({0.1, 1.99}, {.length = "mm"}).find("is 100 mm wide"), std::string::npos);
  EXPECT_TRUE(narrow_rim_sentence({0.1, 2}, {}).empty());
}

/// Mises' stress of the Jaumann rate in simple shear is sqrt(3) 2 mu sin(gamma / 2), and gamma = 2 xi g.
TEST(Rim, EndsWhereJ2Yields) {
  const double E = 1000, nu = 0.3, yield = 140, peak = 0.1, mu = E / (2 * (1 + nu)), h = 0.05;
  const Vortex vortex{0.75, 1.25, 2, {Amplitude::Type::one_minus_cosine, peak, 1.0}};
  const auto material = builtin_material(assay_builtin_j2_jaumann,
                                         {{"E", E}, {"nu", nu}, {"yield_stress", yield}, {"hardening_modulus", 200}});
  const Response response(Sheet(*material, vortex.baseline(), {.tolerance = 1e-6, .end = 1.0}));
  const double xi = std::asin(yield / (std::sqrt(3.0) * 2 * mu)) / peak, fronts[] = {-xi, xi};
  const auto zones = zones_beyond(vortex, fronts);
  ASSERT_EQ(zones.size(), 2u);
  const double width = std::min(zones[0].upper - zones[0].lower, zones[1].upper - zones[1].lower);
  const auto rim = rim_of(response, vortex, h, 1.0);
  ASSERT_TRUE(rim);
  EXPECT_NEAR(rim->width, width, 1e-8);
  EXPECT_NEAR(rim->cells, width / h, 1e-6);
}

class RimOfARun : public testing::Test {
 protected:
  /// result.json's rim and what the run said on standard error.
  std::pair<nlohmann::json, std::string> run_of(const std::string& material, const std::string& spacing) {
    testing::internal::CaptureStderr();
    const auto result =
        result_of_run("models/vortex_" + material, {"grid.spacing=" + spacing, "time.end=0.5", "force.tolerance=1e-4"});
    return {result["rim"], testing::internal::GetCapturedStderr()};
  }
};
using LongRimOfARun = RimOfARun;

TEST_F(LongRimOfARun, CoarseGridsAreWarnedOfAndFineOnesAreNot) {
  const auto [coarse, warned] = run_of("j2_multiplicative", "0.1");
  const auto [fine, silent] = run_of("j2_multiplicative", "0.05");
  EXPECT_NE(warned.find("warning: the plastic rim is"), std::string::npos) << warned;
  EXPECT_EQ(silent.find("plastic rim"), std::string::npos) << silent;
  EXPECT_LT(coarse["cells"].get<double>(), 2);
  EXPECT_GE(fine["cells"].get<double>(), 2);
  EXPECT_NEAR(coarse["width"].get<double>(), fine["width"].get<double>(), 1e-9);
}

TEST_F(RimOfARun, SmoothMaterialsHaveNone) {
  const auto [rim, said] = run_of("neo_hookean", "0.1");
  EXPECT_TRUE(rim["width"].is_null());
  EXPECT_TRUE(rim["cells"].is_null());
  EXPECT_EQ(said.find("rim"), std::string::npos);
}

}  // namespace
}  // namespace assay::drivers::test_rim
