// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/check/check_foreign.hpp"

#include <gtest/gtest.h>

#include "tests/drivers/foreign_checks.hpp"

namespace assay::drivers::test_check_energies {
namespace {

std::string j2(const std::string& words, const std::string& yield = "10") {
  return "interface: vumat\nflags: [non_smooth]\nproperties: {E: 1.0e3, nu: 0.3, yield: " + yield +
         ", H: 20}\nstate: 1\nmaterial_name: " + words + "\n";
}

TEST(CheckEnergies, ShearsCountAsExtensionsDo) {
  if (!has_foreign("vumat_j2")) GTEST_SKIP() << "no Fortran compiler";
  const ForeignCheck right("vumat_j2", j2("ASSAY"));
  EXPECT_EQ(right.status, 0) << right.said;
  EXPECT_EQ(right.verdict_of("energy"), "pass") << right.said;
}

TEST(LongCheckEnergies, ShearsThatCountOnceAreNamedInFlowAndBefore) {
  if (!has_foreign("vumat_j2")) GTEST_SKIP() << "no Fortran compiler";
  for (const char* yield : {"10", "1e9"}) {
    const ForeignCheck once("vumat_j2", j2("ONCE", yield));
    EXPECT_EQ(once.status, 1) << once.said;
    EXPECT_EQ(once.cause(), check::causes::energy) << once.said;
    EXPECT_NE(once.sentence().find("counts the work of a shear 0.5"), std::string::npos) << once.sentence();
  }
}

/// One that counts nothing is none the worse.
TEST(CheckEnergies, WhoCountsNoneIsNotJudged) {
  if (!has_foreign("umat_j2")) GTEST_SKIP() << "no Fortran compiler";
  const ForeignCheck umat("umat_j2",
                          "interface: umat\nproperties: {E: 1.0e3, nu: 0.3, yield: 10, isotropic: 20, kinematic: 50}\n"
                          "state: {back_stress: symmetric_tensor, p: scalar}\nflags: [non_smooth]\n");
  EXPECT_EQ(umat.verdict_of("energy"), "n/a") << umat.said;
}

}  // namespace
}  // namespace assay::drivers::test_check_energies
