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
