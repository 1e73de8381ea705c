// SPDX-License-Identifier: BSD-3-Clause
// `symmetry:` of descriptions: UMATs of crystals and of Hill's plasticity, right and with classic mistakes.
#include <gtest/gtest.h>

#include "drivers/material/material_choice.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "tests/drivers/process.hpp"
#include "tests/support/built.hpp"
#include "tests/support/some_of.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_check_symmetry {
namespace {

const std::string cube =
    "C11: 1000, C22: 1000, C33: 1000, C12: 600, C13: 600, C23: 600, C1212: 500, C1313: 500, C2323: 500, C21: 1";
const std::string lamina =
    "C11: 1400, C22: 140, C33: 230, C12: 100, C13: 150, C23: 80, C1212: 107, C1313: 161, C2323: 46, C21: 1.4";
const std::string bundle =
    "C11: 120, C22: 120, C33: 900, C12: 60, C13: 50, C23: 50, C1212: 30, C1313: 45, C2323: 45, C21: 1";
const std::string slack_bundle =
    "C11: 120, C22: 120, C33: 900, C12: 60, C13: 50, C23: 50, C1212: 24, C1313: 45, C2323: 45, C21: 1";
const std::string inclined = ", phi1: 0.4, tilt: 0.9, phi2: 1.7", upright = ", phi1: 0, tilt: 0, phi2: 0";
const std::string sheet = "E: 1.0e3, nu: 0.3, yield: 8, H: 40, F: 0.3, G: 0.5, hill_H: 0.7, L: 1.2, M: 1.6, N: 2.1";
const std::string round_sheet =
    "E: 1.0e3, nu: 0.3, yield: 8, H: 40, F: 0.5, G: 0.5, hill_H: 0.8, L: 1.6, M: 1.6, N: 2.1";

struct Case {
  const char* name;
  std::string library, properties, symmetry;
  std::string diagnosis;  ///< empty: it passes
  std::string words;      ///< of the finding, or of the sentences of what passes
};

class CheckSymmetry : public testing::TestWithParam<Case> {
 protected:
  static std::string keys(const Case& c) {
    std::string text =
        "interface: umat\nproperties: {" + c.properties + "}\nsymmetry: " + c.symmetry + "\ndensity: 1000\n";
    if (c.library == "umat_hill") return text + "axes: corotational\nstate: [p]\nflags: [non_smooth]\n";
    if (c.library.find("green") != std::string::npos) return text + "strain: finite\n";
    if (c.library.find("corotational") != std::string::npos) return text + "axes: corotational\n";
    return text + "state: {axis: {kind: vector, count: 3}}\n";
  }
};

TEST_P(CheckSymmetry, IsFoundOrItsMistakeIsNamed) {
  const Case& c = GetParam();
  const std::string library = built("tests/foreign/") + c.library + ".so";
  if (!std::filesystem::exists(library)) GTEST_SKIP() << "no Fortran compiler";
  const ScratchFolder scratch;
  const std::string model = scratch.write("crystal.yaml", "library: " + library + "\n" + keys(c));
  const Ending ending = assay({"check", model, "--quick", "--verbose", "-o", scratch / "check"});
  EXPECT_EQ(ending.status, c.diagnosis.empty() ? 0 : 1) << ending.said;
  if (!c.diagnosis.empty()) {
    const auto at = ending.said.find("diagnosis: ");
    ASSERT_NE(at, std::string::npos) << ending.said;
    EXPECT_EQ(ending.said.substr(at, 11 + c.diagnosis.size()), "diagnosis: " + c.diagnosis) << ending.said;
  }
  std::string joined = ending.said;  // lines are broken where they are long
  for (std::size_t k; (k = joined.find("\n")) != std::string::npos;) joined.replace(k, 1, " ");
  for (std::size_t k; (k = joined.find("  ")) != std::string::npos;) joined.replace(k, 2, " ");
  EXPECT_NE(joined.find(c.words), std::string::npos) << c.words << "\n" << ending.said;
}

const std::string not_of_class = "material not of the declared symmetry";

const auto cases_of_check_symmetry = one_of_each<CheckSymmetry::ParamType>(
    4,
    testing::Values(
        Case{"cube", "umat_crystal", cube + inclined, "cubic", "", "the stiffness at rest is cubic about"},
        Case{"upright_cube", "umat_crystal", cube + upright, "cubic", "", "cubic about (1, 0, 0)"},
        Case{"held_cube", "umat_crystal_corotational", cube + inclined, "cubic", "", "cubic about"},
        Case{"green_cube", "umat_crystal_green", cube + inclined, "cubic", "", "rotations of a material that is cubic"},
        Case{"bundle", "umat_crystal_green", bundle + inclined, "transversely_isotropic", "",
             "transversely isotropic about"},
        Case{"cube_as_orthotropic", "umat_crystal_green", cube + inclined, "orthotropic", "", "and cubic at that"},
        Case{"wrong_sign", "umat_crystal_green_wrong_sign", cube + inclined, "cubic", not_of_class, "off by"},
        Case{"turning_wrong_sign", "umat_crystal_wrong_sign", cube + inclined, "cubic", not_of_class, "off by"},
        Case{"held_wrong_sign", "umat_crystal_corotational_wrong_sign", cube + inclined, "cubic", not_of_class,
             "off by"},
        Case{"stress_bond", "umat_crystal_stress_bond", cube + inclined, "cubic", "shear factor 2",
             "is that with the shear components of the strain halved"},
        Case{"held_stress_bond", "umat_crystal_corotational_stress_bond", cube + inclined, "cubic", "shear factor 2",
             "is that with the shear components of the strain halved"},
        Case{"turned_on", "umat_crystal_turned_on", cube + inclined, "cubic", not_of_class, "off by"},
        Case{"green_turned_on", "umat_crystal_green_turned_on", cube + inclined, "cubic", not_of_class, "off by"},
        Case{"lamina", "umat_crystal_green", lamina + inclined, "orthotropic", "negative dissipation",
             "at rest it is orthotropic, but in its axes"},
        Case{"turning_lamina", "umat_crystal", lamina + inclined, "orthotropic", "negative dissipation", "nu12 / E1"},
        Case{"slack_bundle", "umat_crystal_green", slack_bundle + inclined, "transversely_isotropic", not_of_class,
             "it is tetragonal"},
        Case{"turning_slack_bundle", "umat_crystal", slack_bundle + inclined, "transversely_isotropic", not_of_class,
             "it is tetragonal"},
        Case{"sheet", "umat_hill", sheet, "orthotropic", "", "and isotropic at that"},
        Case{"round_sheet", "umat_hill", round_sheet, "transversely_isotropic", "", "isotropic, about (0, 0, 1)"},
        Case{"sheet_called_round", "umat_hill", sheet, "transversely_isotropic", not_of_class,
             "it is orthotropic about"},
        Case{"sheet_called_cubic", "umat_hill", round_sheet, "cubic", not_of_class, "it is transversely isotropic"}));
const auto name_of_check_symmetry = [](const auto& the) { return std::string(the.param.name); };
INSTANTIATE_TEST_SUITE_P(Umats, CheckSymmetry, testing::ValuesIn(cases_of_check_symmetry.some), name_of_check_symmetry);
INSTANTIATE_TEST_SUITE_P(LongUmats, CheckSymmetry, testing::ValuesIn(cases_of_check_symmetry.others),
                         name_of_check_symmetry);

/// The vortex is for what is isotropic about the ring's axis.
TEST(LongCheckSymmetryOfRings, ABundleAlongTheAxisServesAVortexAndAnInclinedOneDoesNot) {
  const std::string library = built("tests/foreign/umat_crystal_green.so");
  if (!std::filesystem::exists(library)) GTEST_SKIP() << "no Fortran compiler";
  const ScratchFolder scratch;
  const auto status = [&](const std::string& properties, const std::string& symmetry) {
    const std::string model =
        scratch.write("bundle.yaml", "library: " + library + "\ninterface: umat\nstrain: finite\nproperties: {" +
                                         properties + "}\nsymmetry: " + symmetry + "\ndensity: 1000\n");
    return assay(
        {"explain", tree_folder() + "/configs/foreign/vortex_umat.yaml", "--set", "material={adapter: " + model + "}"});
  };
  EXPECT_EQ(status(bundle + upright, "transversely_isotropic").status, 0);
  EXPECT_EQ(status(bundle + upright, "anisotropic").status, 2);
  EXPECT_EQ(status(slack_bundle + upright, "transversely_isotropic").status, 2);
  const Ending refused = status(bundle + inclined, "transversely_isotropic");
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.said.find("transversely isotropic about it"), std::string::npos) << refused.said;
}

}  // namespace
}  // namespace assay::drivers::test_check_symmetry
