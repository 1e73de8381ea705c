// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/check/check_foreign.hpp"

#include <gtest/gtest.h>

#include "tests/drivers/foreign_checks.hpp"
#include "tests/drivers/material/fortran_texts.hpp"

namespace assay::drivers::test_check_components {
namespace {

TEST(LongCheckComponents, AModelOfPlaneStrainIsToldWhatCuresIt) {
  if (!has_foreign("umat_in_plane")) GTEST_SKIP() << "no Fortran compiler";
  const std::string keys = "interface: umat\nproperties: {E: 1.0e3, nu: 0.3}\n";
  const ForeignCheck check("umat_in_plane", keys);
  EXPECT_EQ(check.status, 1) << check.said;
  EXPECT_EQ(check.sentence().find("with components: [4] in its description it passes"), 0u) << check.said;
  EXPECT_EQ(check.found["diagnosis"].size(), 1u) << check.said;
  EXPECT_FALSE(check.says("symmetry: anisotropic")) << "no other advice: " << check.said;
  const ForeignCheck cured("umat_in_plane", keys + "components: [4]\n");
  EXPECT_EQ(cured.status, 0) << cured.said;
  const ForeignCheck declared("umat_in_plane", keys + "components: [6]\n");
  EXPECT_EQ(declared.status, 1) << declared.said;
  EXPECT_FALSE(declared.says("components: [4]")) << "it is said to serve six: " << declared.said;
}

/// As many write it in free form: six components are no overrun, and those out of the plane have no stiffness.
TEST(CheckComponents, OneThatLeavesTheOthersAloneIsToldTheSame) {
  if (!has_foreign("umat_in_plane")) GTEST_SKIP() << "no Fortran compiler";
  const ScratchFolder scratch;
  const auto checked = [&](const std::string& name, const std::string& shear) {
    std::string text = free_hooke_umat;
    const std::string end = "  stress = stress + matmul(ddsdde, dstran)\n";
    text.insert(text.find(end), "  if (ntens > 4) ddsdde(5:, 5:) = 0\n  ddsdde(4, 4) = " + shear + "\n");
    assay({"check", scratch.write(name + ".f90", text), "--props", "1e3,.3", "--statev", "4", "--quick", "--json",
           scratch / "c.json", "-o", scratch / "r"});
    return nlohmann::json::parse(bytes_of(scratch / "c.json"));
  };
  const auto good = checked("good", "eg");
  ASSERT_EQ(good["diagnosis"].size(), 1u) << good["diagnosis"].dump();
  const std::string sentence = good["diagnosis"][0]["sentence"];
  EXPECT_EQ(sentence.find("with components: [4] in its description it passes"), 0u) << sentence;
  EXPECT_EQ(good.dump().find("anisotropic"), std::string::npos) << good.dump();
  EXPECT_EQ(good.dump().find("belongs to a tensor"), std::string::npos) << good.dump();
  const auto bad = checked("bad", "2*eg");
  const std::string other = bad["diagnosis"][0]["sentence"];
  EXPECT_EQ(other.find("it passes: it fills the components"), std::string::npos) << other;
}

/// Too few STATEV are declared for six components, and enough for four: it serves both, and the first advice is to
/// declare them.
TEST(CheckComponents, TooSmallAStateIsNoPlane) {
  if (!has_foreign("umat_in_plane")) GTEST_SKIP() << "no Fortran compiler";
  const ScratchFolder scratch;
  std::string text = free_hooke_umat;
  const std::string end = "end subroutine umat\n";
  text.insert(text.find(end), "  stress(1) = stress(1) + 0*statev(ntens)\n");
  assay({"check", scratch.write("law.f90", text), "--props", "1e3,.3", "--statev", "4", "--quick", "--json",
         scratch / "c.json", "-o", scratch / "r"});
  const auto found = nlohmann::json::parse(bytes_of(scratch / "c.json"));
  ASSERT_FALSE(found["diagnosis"].empty());
  EXPECT_EQ(found["diagnosis"][0]["cause"], "state not declared") << found["diagnosis"].dump();
  const std::string sentence = found["diagnosis"][0]["sentence"];
  EXPECT_EQ(sentence.find("reads STATEV(6), 4 are declared: `state` must declare 6 numbers"), 0u) << sentence;
}

TEST(LongCheckComponents, PlaneStressIsJudgedInItsPlane) {
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
TEST(LongCheckComponents, WhatIsWrongInPlaneStressIsNamed) {
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
