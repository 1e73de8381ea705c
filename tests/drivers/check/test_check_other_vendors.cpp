// SPDX-License-Identifier: BSD-3-Clause
// `check` of Ansys' USERMAT and of LS-DYNA's user materials.
#include <gtest/gtest.h>

#include "tests/drivers/foreign_checks.hpp"

namespace assay::drivers::test_check_other_vendors {
namespace {

std::string keys_of(const std::string& interface, int which, const std::string& more = "") {
  return "interface: " + interface +
         "\nproperties: {E: 1.0e3, nu: 0.3, yield: 10, isotropic: 20, which: " + std::to_string(which) +
         "}\nstate: {p: scalar}\nflags: [non_smooth]\n" + more;
}

TEST(LongCheckOtherVendors, ModelsThatAreRightPass) {
  if (!has_foreign("usermat_j2")) GTEST_SKIP() << "no Fortran compiler";
  for (const char* more : {"", "axes: fixed\n", "components: [4]\n"}) {
    const ForeignCheck check("usermat_j2", keys_of("usermat", 0, more));
    EXPECT_EQ(check.status, 0) << more << check.said;
    EXPECT_EQ(check.verdict_of("tangent"), "pass") << more;
    EXPECT_EQ(check.verdict_of("calls.host"), "pass") << more;
  }
  EXPECT_EQ(ForeignCheck("lsdyna_j2", keys_of("lsdyna", 0)).status, 0);
  EXPECT_EQ(ForeignCheck("lsdyna_j2", keys_of("lsdyna", 0, "symbol: umat42_\narguments: 16\n")).status, 0);
  const ForeignCheck hyper("lsdyna_j2", keys_of("lsdyna", 6, "strain: finite\n"));
  EXPECT_EQ(hyper.status, 0) << hyper.said;
}

TEST(CheckOtherVendors, WhatIsWrongIsNamed) {
  if (!has_foreign("usermat_j2")) GTEST_SKIP() << "no Fortran compiler";
  const ForeignCheck shears("usermat_j2", keys_of("usermat", 5));
  EXPECT_EQ(shears.status, 1) << shears.said;
  EXPECT_EQ(shears.cause(), "shear factor 2") << shears.said;
  const ForeignCheck over("usermat_j2", keys_of("usermat", 3));
  EXPECT_EQ(over.status, 1);
  EXPECT_NE(over.sentence().find("writes ustatev(2), 1 is declared"), std::string::npos) << over.said;
  const ForeignCheck history("lsdyna_j2", keys_of("lsdyna", 3));
  EXPECT_EQ(history.status, 1);
  EXPECT_NE(history.sentence().find("writes hsv(2), 1 is declared"), std::string::npos) << history.said;
  const ForeignCheck axes("usermat_j2", keys_of("usermat", 6, "axes: fixed\n"));
  EXPECT_EQ(axes.status, 1) << "its stress is that in the axes of R: " << axes.said;
  EXPECT_EQ(axes.cause(), "increment rotation missing") << axes.said;
  EXPECT_NE(axes.sentence().find("with `axes: corotational` in its description it is right"), std::string::npos)
      << axes.said;
}

/// It reads F behind its one number.
TEST(CheckOtherVendors, AModelOfFIsToldToDeclareIt) {
  if (!has_foreign("lsdyna_j2")) GTEST_SKIP() << "no Fortran compiler";
  const ForeignCheck check("lsdyna_j2", keys_of("lsdyna", 6));
  EXPECT_EQ(check.cause(), "state not declared") << check.said;
  EXPECT_NE(check.sentence().find("1 is declared: F stands there with IHYPER = 1: declare `strain: "
                                  "finite`"),
            std::string::npos)
      << check.sentence();
}

TEST(LongCheckOtherVendors, ATangentOfAnotherConventionIsNamed) {
  if (!has_foreign("usermat_j2")) GTEST_SKIP() << "no Fortran compiler";
  for (const char* axes : {"", "components: [4]\n"}) {
    const ForeignCheck truesdell("usermat_j2", keys_of("usermat", 7, axes));
    EXPECT_EQ(truesdell.cause(), "tangent of another convention") << axes << truesdell.said;
    EXPECT_NE(truesdell.sentence().find("dsdePl is the modulus of the Truesdell rate, as by pushing"),
              std::string::npos)
        << truesdell.sentence();
  }
  const ForeignCheck of_tau("usermat_j2", keys_of("usermat", 8));
  EXPECT_NE(of_tau.sentence().find("dsdePl is the modulus of the Truesdell rate of the Kirchhoff stress"),
            std::string::npos)
      << of_tau.said;
}

TEST(CheckOtherVendors, ALibraryWithoutADescriptionIsNamed) {
  if (!has_foreign("usermat_j2")) GTEST_SKIP() << "no Fortran compiler";
  const ScratchFolder scratch;
  const auto said = [&](const std::string& name) {
    return assay({"check", built("tests/foreign/") + name + ".so", "-o", scratch / "out"}).said;
  };
  EXPECT_NE(said("usermat_j2").find("'usermat_', a USERMAT: it needs a description"), std::string::npos)
      << said("usermat_j2");
  EXPECT_NE(said("lsdyna_j2").find("interface: lsdyna"), std::string::npos) << said("lsdyna_j2");
}

}  // namespace
}  // namespace assay::drivers::test_check_other_vendors
