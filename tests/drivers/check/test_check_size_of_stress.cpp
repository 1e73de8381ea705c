// SPDX-License-Identifier: BSD-3-Clause
// `check` of moduli near the bounds of what a model takes.
#include <gtest/gtest.h>

#include "tests/drivers/process.hpp"

namespace assay::drivers::test_check_size_of_stress {
namespace {

/// The vortex is run with a second material of the same stiffness beside it.
TEST(CheckSizeOfStress, TheWholeBatteryAndTheVortexPass) {
  const Ending ending = assay({"check", "neo_hookean", "--parameters", "E=1e160"});
  EXPECT_EQ(ending.status, 0) << ending.said;
  EXPECT_NE(ending.said.find("\nvortex                    pass "), std::string::npos) << ending.said;
  EXPECT_EQ(ending.said.find("nan"), std::string::npos) << ending.said;
}

/// At the bounds themselves no other material can stand beside it, and that says nothing of this one.
TEST(CheckSizeOfStress, BothBoundsPass) {
  for (const char* E : {"E=1e-300", "E=1e290", "E=1e300"}) {
    const Ending ending = assay({"check", "neo_hookean", "--quick", "--parameters", E});
    EXPECT_EQ(ending.status, 0) << E << "\n" << ending.said;
  }
}

}  // namespace
}  // namespace assay::drivers::test_check_size_of_stress
