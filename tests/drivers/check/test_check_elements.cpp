// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/check/check_foreign.hpp"

#include <gtest/gtest.h>

#include "tests/drivers/foreign_checks.hpp"

namespace assay::drivers::test_check_elements {
namespace {

std::string keeping_p(const std::string& keys, const std::string& words = "KEEPS_P") {
  return "interface: umat\nflags: [non_smooth]\nproperties: {E: 1.0e3, nu: 0.3, yield: 10, C: 50}\n"
         "state: {back_stress: symmetric_tensor, p: scalar}\nmaterial_name: " +
         words + "\n" + keys;
}

TEST(LongCheckElements, AStateThatIsKeptByElementIsCalledThat) {
  if (!has_foreign("umat_kinematic")) GTEST_SKIP() << "no Fortran compiler";
  const ForeignCheck check("umat_kinematic", keeping_p(""));
  EXPECT_EQ(check.status, 1) << check.said;
  EXPECT_EQ(check.cause(), check::causes::kept_by_element) << check.said;
  EXPECT_NE(check.sentence().find("elements: each in its description"), std::string::npos) << check.sentence();
  const ForeignCheck each("umat_kinematic", keeping_p("elements: each\n"));
  EXPECT_EQ(each.cause(), check::causes::kept_by_element) << each.said;
  EXPECT_NE(each.sentence().find("`elements: each` is enough only for runs that take each point once a step"),
            std::string::npos)
      << each.sentence();
}

/// Of two bodies in one element the lesser leaves no trace in a largest value.
TEST(CheckElements, ALargestValueByElementIsCalledThatToo) {
  if (!has_foreign("umat_kinematic")) GTEST_SKIP() << "no Fortran compiler";
  const ForeignCheck check("umat_kinematic", keeping_p("", "KEEPS_PEAK"));
  EXPECT_EQ(check.cause(), check::causes::kept_by_element) << check.said;
}

/// Another state outside of STATEV is not one by element.
TEST(CheckElements, WhatIsKeptForAllIsHiddenState) {
  if (!has_foreign("misbehaving_umat")) GTEST_SKIP() << "no Fortran compiler";
  const ForeignCheck check("umat_kinematic", keeping_p("elements: each\nnpt: 2\n"), {"--quick", "--strain", "0.001"});
  EXPECT_NE(check.cause(), check::causes::kept_by_element) << "it stays elastic: " << check.said;
}

/// A model that needs no element of its own is none the worse for having one.
TEST(CheckElements, AnElementForEachPointHarmsNobody) {
  if (!has_foreign("umat_j2")) GTEST_SKIP() << "no Fortran compiler";
  const ForeignCheck check("umat_j2",
                           "interface: umat\nproperties: {E: 1.0e3, nu: 0.3, yield: 10, isotropic: 20, kinematic: 50}\n"
                           "state: {back_stress: symmetric_tensor, p: scalar}\nflags: [non_smooth]\nelements: each\n");
  EXPECT_EQ(check.status, 0) << check.said;
}

}  // namespace
}  // namespace assay::drivers::test_check_elements
