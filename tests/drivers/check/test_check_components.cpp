// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/check/check_foreign.hpp"

#include <gtest/gtest.h>

#include "tests/drivers/foreign_checks.hpp"

namespace assay::drivers::test_check_components {
namespace {

TEST(CheckComponents, AModelOfPlaneStrainIsToldWhatCuresIt) {
  if (!has_foreign("umat_in_plane")) GTEST_SKIP() << "no Fortran compiler";
  const std::string keys = "interface: umat\nproperties: {E: 1.0e3, nu: 0.3}\n";
  const ForeignCheck check("umat_in_plane", keys);
  EXPECT_EQ(check.status, 1) << check.said;
  EXPECT_NE(check.sentence().find("with components: [4] in its description it passes"), std::string::npos)
      << check.said;
  const ForeignCheck cured("umat_in_plane", keys + "components: [4]\n");
  EXPECT_EQ(cured.status, 0) << cured.said;
  const ForeignCheck declared("umat_in_plane", keys + "components: [6]\n");
  EXPECT_EQ(declared.status, 1) << declared.said;
  EXPECT_FALSE(declared.says("components: [4]")) << "it is said to serve six: " << declared.said;
}

TEST(CheckComponents, PlaneStressIsJudgedInItsPlane) {
  if (!has_foreign("umat_plane_stress")) GTEST_SKIP() << "no Fortran compiler";
  const auto keys = [](int law, const std::string& more) {
    return "interface: umat\ncomponents: [3]\nproperties: {E: 1.0e3, nu: 0.3, law: " + std::to_string(law) + "}\n" +
           more;
  };
  for (const char* thickness : {"0.3", "constant", "incompressible"}) {
    const ForeignCheck sheet("umat_plane_stress", keys(1, std::string("thickness: ") + thickness + "\n"), {});
    EXPECT_EQ(sheet.status, 0) << thickness << sheet.said;
    EXPECT_EQ(sheet.verdict_of("vortex"), "n/a") << thickness;
  }
  const ForeignCheck rubber("umat_plane_stress", keys(2, "strain: finite\n"));
  EXPECT_EQ(rubber.status, 0) << rubber.said;
  EXPECT_EQ(rubber.verdict_of("tangent"), "pass") << rubber.said;
  // J is 1 where the thickness makes it so, and both conventions are one; its DDSDDE has no term of J elsewhere
  EXPECT_EQ(ForeignCheck("umat_plane_stress", keys(2, "strain: small\n")).status, 0);
  const ForeignCheck other("umat_plane_stress", keys(2, "strain: finite\nthickness: constant\n"));
  EXPECT_EQ(other.cause(), "tangent of another convention") << other.said;
  const ForeignCheck four("umat_plane_stress", keys(3, ""));
  EXPECT_NE(four.sentence().find("writes STRESS(4)"), std::string::npos) << four.said;
}

/// Both shears of the plane are doubled, and the transpose of F is taken.
TEST(CheckComponents, WhatIsWrongInPlaneStressIsNamed) {
  if (!has_foreign("umat_plane_stress")) GTEST_SKIP() << "no Fortran compiler";
  const auto cause = [](int law, const std::string& more) {
    return ForeignCheck("umat_plane_stress", "interface: umat\ncomponents: [3]\nproperties: {E: 1.0e3, nu: 0.3, law: " +
                                                 std::to_string(law) + "}\n" + more)
        .cause();
  };
  EXPECT_EQ(cause(5, "thickness: 0.3\n"), "shear factor 2");
  EXPECT_EQ(cause(6, "strain: finite\n"), "increment rotation missing");
}

TEST(CheckComponents, AnotherDefectIsNotCuredByThem) {
  if (!has_foreign("umat_j2_unrotated")) GTEST_SKIP() << "no Fortran compiler";
  const ForeignCheck check("umat_j2_unrotated",
                           "interface: umat\nproperties: {E: 1.0e3, nu: 0.3, yield: 10, isotropic: 20, kinematic: 50}\n"
                           "state: {back_stress: symmetric_tensor, p: scalar}\nflags: [non_smooth]\n");
  EXPECT_EQ(check.status, 1) << check.said;
  EXPECT_FALSE(check.says("components: [4]")) << check.said;
}

}  // namespace
}  // namespace assay::drivers::test_check_components
