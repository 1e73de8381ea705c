// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/check/check_foreign.hpp"

#include <gtest/gtest.h>

#include "tests/drivers/foreign_checks.hpp"
#include "tests/drivers/process.hpp"
#include "tests/support/built.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_check_foreign {
namespace {

const std::string doubles = built("tests/foreign/");

bool built(const std::string& name) { return std::filesystem::exists(doubles + name + ".so"); }

std::string described(const ScratchFolder& scratch, const std::string& library, const std::string& keys) {
  return scratch.write(library + ".yaml", "library: " + doubles + library + ".so\n" + keys);
}

std::string j2_of(const ScratchFolder& scratch, const std::string& library, const std::string& keys) {
  return described(scratch, library,
                   "interface: umat\nproperties: {E: 1.0e3, nu: 0.3, yield: 10, isotropic: 20, kinematic: 50}\n"
                   "state: {back_stress: symmetric_tensor, p: scalar}\nflags: [non_smooth]\ndensity: 1000\n" +
                       keys);
}

/// Of a plane-strain model.
std::string neo_hookean_in_plane(const ScratchFolder& scratch) {
  return described(scratch, "umat_neo_hookean",
                   "interface: umat\nproperties: {E: 1.0e3, nu: 0.3}\nstrain: finite\ncomponents: [4]\n"
                   "density: 1000\n");
}

TEST(LongCheckForeign, AModelOfPlaneStrainAloneIsTurnedAndStrainedInItsPlane) {
  if (!built("umat_neo_hookean")) GTEST_SKIP() << "no Fortran compiler";
  const ScratchFolder scratch;
  const std::string model = neo_hookean_in_plane(scratch);
  const Ending ending = assay({"check", model, "-o", scratch / "check"});
  EXPECT_EQ(ending.status, 0) << ending.said;
  EXPECT_NE(ending.said.find("ellipticity"), std::string::npos) << ending.said;
  EXPECT_NE(ending.said.find("; shears out of the plane;"), std::string::npos) << ending.said;
  EXPECT_EQ(ending.said.find("out of the plane", ending.said.find("\ntest ")), std::string::npos) << ending.said;
  const Ending shown = assay({"materials", model});
  EXPECT_NE(shown.said.find("plane 12 alone"), std::string::npos) << shown.said;
}

TEST(LongCheckForeign, AModelOfPlaneStrainAloneRunsTheVortex) {
  if (!built("umat_neo_hookean")) GTEST_SKIP() << "no Fortran compiler";
  const ScratchFolder scratch;
  const std::string model = neo_hookean_in_plane(scratch);
  const Ending ending = assay({"run", tree_folder() + "/configs/foreign/vortex_umat.yaml", "-o", scratch / "out",
                               "--quiet", "--set", "material={adapter: " + model + "}"});
  EXPECT_EQ(ending.status, 0) << ending.said;
}

TEST(LongCheckForeign, WhatIsWrongInThePlaneIsNamed) {
  if (!built("umat_j2")) GTEST_SKIP() << "no Fortran compiler";
  const ScratchFolder scratch;
  for (const bool right : {true, false}) {
    const std::string model = j2_of(scratch, right ? "umat_j2" : "umat_j2_unrotated", "components: [4]\n");
    const Ending ending = assay({"check", model, "--quick", "-o", scratch / "check"});
    EXPECT_EQ(ending.status, right ? 0 : 1) << ending.said;
    EXPECT_EQ(ending.said.find("state variable not rotated") == std::string::npos, right) << ending.said;
  }
}

TEST(CheckForeign, ATangentOfTheOtherStrainIsSaidInTheWordsOfDescriptions) {
  if (!built("umat_neo_hookean")) GTEST_SKIP() << "no Fortran compiler";
  const ScratchFolder scratch;
  const std::string model = described(
      scratch, "umat_neo_hookean", "interface: umat\nproperties: {E: 1.0e3, nu: 0.3}\nstrain: small\ndensity: 1000\n");
  const Ending ending = assay({"check", model, "-o", scratch / "check"});
  EXPECT_EQ(ending.status, 1);
  EXPECT_NE(ending.said.find("tangent of another convention"), std::string::npos) << ending.said;
  EXPECT_NE(ending.said.find("strain: finite"), std::string::npos) << ending.said;
  EXPECT_EQ(ending.said.find("row-major"), std::string::npos) << ending.said;
}

TEST(LongCheckForeign, ATangentOfWhichNothingIsSaidIsTakenForEither) {
  if (!built("umat_neo_hookean")) GTEST_SKIP() << "no Fortran compiler";
  const ScratchFolder scratch;
  const std::string finite =
      described(scratch, "umat_neo_hookean", "interface: umat\nproperties: {E: 1.0e3, nu: 0.3}\ndensity: 1000\n");
  const Ending ending = assay({"check", finite, "-o", scratch / "check"});
  EXPECT_EQ(ending.status, 0) << ending.said;
  EXPECT_NE(ending.said.find("strain: finite"), std::string::npos) << ending.said;
  EXPECT_NE(ending.said.find("it passes, so declare that"), std::string::npos) << ending.said;
  const Ending small = assay({"check", j2_of(scratch, "umat_j2", ""), "--quick", "-o", scratch / "check"});
  EXPECT_EQ(small.status, 0) << small.said;
  EXPECT_EQ(small.said.find("it passes, so declare that"), std::string::npos) << small.said;
}

/// Moduli that are handed over as textbooks have them.
TEST(LongCheckForeign, ModuliOfAnotherRateAreNamed) {
  if (!built("umat_neo_hookean")) GTEST_SKIP() << "no Fortran compiler";
  const std::pair<const char*, const char*> all[] = {
      {"TRUESDELL", "DDSDDE is the modulus of the Truesdell rate, as by"},
      {"OF_TAU", "DDSDDE is J times the modulus that is asked for"},
      {"TRUESDELL OF_TAU", "the Truesdell rate of the Kirchhoff stress"}};
  for (const auto& [words, said] : all) {
    for (const char* strain : {"", "strain: finite\n"}) {
      const ForeignCheck check("umat_neo_hookean", "interface: umat\nproperties: {E: 1.0e3, nu: 0.3}\nmaterial_name: " +
                                                       std::string(words) + "\n" + strain);
      EXPECT_EQ(check.status, 1) << words;
      EXPECT_EQ(check.cause(), check::causes::tangent_convention) << check.said;
      EXPECT_NE(check.sentence().find(said), std::string::npos) << check.sentence();
    }
  }
}

/// Engineering and tensor shears, mixed up in DDSDDE alone.
TEST(LongCheckForeign, ShearsOfTheTangentThatAreDoubledOrHalvedAreNamed) {
  if (!built("umat_kinematic")) GTEST_SKIP() << "no Fortran compiler";
  const std::pair<const char*, const char*> all[] = {
      {"SHEARS_DOUBLED", "the shears 12, 13, 23 of the tangent are doubled"},
      {"SHEARS_HALVED", "the shears 12, 13, 23 of the tangent are halved"},
      {"ONE_DOUBLED", "the shear 23 of the tangent is doubled"}};
  for (const auto& [words, said] : all) {
    const ForeignCheck check("umat_kinematic",
                             "interface: umat\nflags: [non_smooth]\nproperties: {E: 1.0e3, nu: 0.3, yield: 10, C: 50}\n"
                             "state: {back_stress: symmetric_tensor, p: scalar}\nmaterial_name: " +
                                 std::string(words) + "\n");
    EXPECT_EQ(check.status, 1) << words;
    EXPECT_EQ(check.cause(), check::causes::tangent_wrong) << check.said;
    EXPECT_NE(check.sentence().find(said), std::string::npos) << check.sentence();
  }
}

/// A Poisson's ratio above 0.5 makes K negative, one below -1 G.
TEST(LongCheckForeign, ABodyThatIsDrivenOnByItsStressIsNamed) {
  if (!built("umat_kinematic")) GTEST_SKIP() << "no Fortran compiler";
  const auto of = [](const std::string& nu, const std::string& more) {
    return ForeignCheck("umat_kinematic", "interface: umat\nflags: [non_smooth]\nproperties: {E: 1.0e3, nu: " + nu +
                                              ", yield: 1e6, C: 50}\n"
                                              "state: {back_stress: symmetric_tensor, p: scalar}\n" +
                                              more);
  };
  for (const char* more : {"", "components: [4]\n"}) {
    for (const char* nu : {"0.7", "2.0"}) {
      const ForeignCheck check = of(nu, more);
      EXPECT_EQ(check.status, 1) << nu;
      EXPECT_EQ(check.cause(), check::causes::not_positive) << check.said;
      EXPECT_NE(check.sentence().find("swells: the bulk modulus at rest is -"), std::string::npos) << check.sentence();
    }
    const ForeignCheck sheared = of("-1.5", more);
    EXPECT_EQ(sheared.cause(), check::causes::not_positive) << sheared.said;
    EXPECT_NE(sheared.sentence().find("at rest gives a stress that increases it: the stiffness against it is -"),
              std::string::npos)
        << sheared.sentence();
    EXPECT_EQ(of("0.49999", more).status, 0);
    EXPECT_EQ(of("-0.99", more).status, 0);
  }
}

/// Energies that a UMAT leaves alone, and numbers of a state that is too long.
TEST(LongCheckForeign, WhatNobodyUsesIsNoRemark) {
  if (!built("umat_kinematic")) GTEST_SKIP() << "no Fortran compiler";
  const ScratchFolder scratch;
  const std::string model = described(scratch, "umat_kinematic",
                                      "interface: umat\nproperties: {E: 1.0e3, nu: 0.3, yield: 10, C: 50}\n"
                                      "state: 50\nflags: [non_smooth]\ndensity: 1000\n");
  const Ending brief = assay({"check", model, "--quick", "-o", scratch / "check"});
  EXPECT_EQ(brief.status, 0) << brief.said;
  EXPECT_EQ(brief.said.find("remark"), std::string::npos) << brief.said;
  EXPECT_EQ(brief.said.find("SPD"), std::string::npos) << brief.said;
  const Ending whole = assay({"check", model, "--quick", "--verbose", "-o", scratch / "check"});
  EXPECT_NE(whole.said.find("STATEV 8-50"), std::string::npos) << whole.said;
}

TEST(CheckForeign, ATangentOfElasticityIsCalledThat) {
  if (!built("umat_j2_elastic_ddsdde")) GTEST_SKIP() << "no Fortran compiler";
  const ScratchFolder scratch;
  const Ending ending =
      assay({"check", j2_of(scratch, "umat_j2_elastic_ddsdde", ""), "--quick", "-o", scratch / "check"});
  EXPECT_EQ(ending.status, 1) << ending.said;
  EXPECT_NE(ending.said.find("diagnosis: tangent wrong"), std::string::npos) << ending.said;
  EXPECT_NE(ending.said.find("the tangent is the elastic tangent at rest"), std::string::npos) << ending.said;
}

/// DDSDDE is right, and is converted as if all had turned.
TEST(CheckForeign, ATangentIsNotJudgedBesideWhatDoesNotTurn) {
  if (!built("umat_j2_unrotated")) GTEST_SKIP() << "no Fortran compiler";
  const ScratchFolder scratch;
  const Ending ending = assay({"check", j2_of(scratch, "umat_j2_unrotated", ""), "--quick", "-o", scratch / "check"});
  EXPECT_EQ(ending.status, 1) << ending.said;
  EXPECT_NE(ending.said.find("diagnosis: state variable not rotated"), std::string::npos) << ending.said;
  EXPECT_EQ(ending.said.find("tangent wrong"), std::string::npos) << ending.said;
}

TEST(CheckForeign, TheTimeSinceTheBeginningIsToldFromThatOfAStep) {
  if (!built("misbehaving_umat")) GTEST_SKIP() << "no Fortran compiler";
  const ScratchFolder scratch;
  const std::string model =
      described(scratch, "misbehaving_umat",
                "interface: umat\nproperties: {E: 1.0e3, nu: 0.3, which: 20, from: 0}\nstate: 1\ndensity: 1000\n");
  const Ending ending = assay({"check", model, "--quick", "-o", scratch / "check"});
  EXPECT_EQ(ending.status, 1) << ending.said;
  EXPECT_NE(ending.said.find("diagnosis: clock"), std::string::npos) << ending.said;
  EXPECT_NE(ending.said.find("the time since"), std::string::npos) << ending.said;
  EXPECT_EQ(ending.said.find("flags: [rate_dependent]"), std::string::npos) << ending.said;
}

TEST(CheckForeign, DeclarationsAreThoseOfDescriptions) {
  const ScratchFolder scratch;
  MaterialChoice native;
  native.adapter = "neo_hookean";
  native.density = 1000;
  native.parameters = {{"E", 1e3}, {"nu", 0.3}};
  EXPECT_EQ(declarations_of(resolve_material(native)).rate_dependence, "ASSAY_RATE_DEPENDENT");
  const std::string model =
      described(scratch, "mfront_norton",
                "interface: mfront\nproperties: {YoungModulus: 1.0e3, PoissonRatio: 0.3, A: 1.0e-3, n: 1}\n"
                "density: 1000\n");
  const Ending ending = assay({"check", model, "--quick", "-o", scratch / "check"});
  EXPECT_EQ(ending.status, 0) << ending.said;
  EXPECT_NE(ending.said.find("Declare flags: [rate_dependent], or"), std::string::npos) << ending.said;
}

TEST(LongCheckForeign, AnInitialValueThatIsMissingIsAskedFor) {
  const ScratchFolder scratch;
  const std::string keys = "interface: mfront\nproperties: {Lambda: 600, Mu: 400}\ndensity: 1000\n";
  const std::string bare = described(scratch, "mfront_elastic_part", keys);
  const Ending without = assay({"check", bare, "-o", scratch / "check"});
  EXPECT_EQ(without.status, 1) << without.said;
  EXPECT_NE(without.said.find("Fe of the state begins at zero; to give it another initial"), std::string::npos)
      << without.said;
  const std::string whole =
      described(scratch, "mfront_elastic_part", keys + "state: {Fe: {initial: [1, 1, 1, 0, 0, 0, 0, 0, 0]}}\n");
  const Ending with = assay({"check", whole, "-o", scratch / "check"});
  EXPECT_EQ(with.status, 0) << with.said;
}

// A library that describes itself, without a description: its model has the name of its behaviour.
TEST(LongCheckForeign, ALibraryOfMFrontIsCheckedAsItIs) {
  const ScratchFolder scratch;
  const std::string library = doubles + "mfront_neo_hookean.so";
  for (const char* name : {"", ":NeoHookean", ":neohookean"}) {
    const Ending ending =
        assay({"check", library + name, "--parameters", "YoungModulus=1e3,PoissonRatio=0.3", "-o", scratch / "check"});
    EXPECT_EQ(ending.status, 0) << ending.said;
  }
  EXPECT_TRUE(assay({"materials", library}).said.starts_with("neohookean ")) << library;
}

}  // namespace
}  // namespace assay::drivers::test_check_foreign
