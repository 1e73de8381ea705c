// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/path/path_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "drivers/system/input_file.hpp"
#include "tests/drivers/scratch_folder.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_path_scene {
namespace {

const std::string metal = "material: {adapter: neo_hookean, parameters: {E: 1.0e+3, nu: 0.3}}\n";

PathScene scene_from(const std::string& text, const std::string& file = "path.yaml") {
  return path_scene_of(read_yaml(text, file), file, {});
}

PathScene path_of(const std::string& path) { return scene_from(metal + "path: " + path + "\n"); }

/// "e11 s22 s33 e12 e13 e23".
std::string rows_of(const PathScene& scene) {
  std::string text;
  for (const PathRow& row : scene.rows) text += (text.empty() ? "" : "; ") + row.quantity.text;
  return text;
}

std::string refusal_of(const std::string& path) {
  try {
    path_of(path);
    return "taken";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(PathScene, SuppliesTheRowsOfEachType) {
  const auto rows = [](const std::string& type, const std::string& control) {
    return rows_of(path_of("{type: " + type + ", control: {" + control + "}}"));
  };
  EXPECT_EQ(rows("uniaxial_stress", "e11: 0.1"), "e11; s22; s33; e12; e13; e23");
  EXPECT_EQ(rows("uniaxial_stress", "P11: 5"), "P11; P22; P33; e12; e13; e23");
  EXPECT_EQ(rows("uniaxial_stress", "F11: 1.1"), "F11; s22; s33; F12; F13; F23; F21; F31; F32");
  EXPECT_EQ(rows("oedometer", "e11: -0.1"), "e11; e22; e33; e12; e13; e23");
  EXPECT_EQ(rows("biaxial", "e11: 0.1"), "e11; e22 - e11; s33; e12; e13; e23");
  EXPECT_EQ(rows("plane_stress", "e11: 0.1, e22: 0.2"), "e11; e22; s33; e12; e13; e23");
  EXPECT_EQ(rows("simple_shear", "F21: 0.5"), "F21; F11; F22; F33; F12; F13; F23; F31; F32");
  EXPECT_EQ(rows("torsion", "F12: 0.5"), "F12; s11; s22; s33; F13; F23; F21; F31; F32");
  EXPECT_EQ(rows("torsion", "e12: 0.5, e11: 0.1"), "e12; e11; s22; s33; e13; e23");
  EXPECT_EQ(rows("isotropic", "s11: -5"), "s11; e22 - e11; e33 - e11; e12; e13; e23");
  EXPECT_EQ(rows("undrained_triaxial", "e11: -0.1"), "e11; e11 + e22 + e33; s22 - s33; e12; e13; e23");
  EXPECT_EQ(rows("undrained_shear", "e12: 0.1"), "e12; e11; e22; e33; e13; e23");
}

/// Beside F a symmetric stress takes the place of the upper component, and the lower one is held.
TEST(PathScene, HoldsWhatNobodyNames) {
  EXPECT_EQ(rows_of(path_of("{control: {F11: 1.1, s22: 0, s33: 0, s12: 0}}")),
            "F11; s22; s33; s12; F13; F23; F21; F31; F32");
  const PathScene scene = path_of("{type: uniaxial_stress, control: {F11: 1.1}}");
  const Control control = control_of(scene);
  EXPECT_EQ(control.rows.size(), 9u);
  const PathScene triaxial = path_of("{type: triaxial, confinement: 7, control: {e11: -0.1}}");
  EXPECT_EQ(control_of(triaxial).rows[1].value(0.5, false), -7);
  EXPECT_EQ(triaxial.initial_stress, (std::array<double, 6>{-7, -7, -7, 0, 0, 0}));
}

TEST(PathScene, ReadsSums) {
  std::string fault;
  const auto sum = parse_quantity("e11 + 2 e22 - 0.5*e33", fault);
  ASSERT_TRUE(sum) << fault;
  const ControlQuantity quantity = control_quantity(*sum, Deformation::logarithmic_strain);
  EXPECT_EQ(quantity.deformation.diagonal(), Vector3(1, 2, -0.5));
  EXPECT_EQ(control_quantity(*parse_quantity("volume", fault), Deformation::logarithmic_strain).deformation,
            Tensor(Tensor::Identity()));
  EXPECT_EQ(control_quantity(*parse_quantity("s21", fault), Deformation::logarithmic_strain).stress(0, 1), 1);
  EXPECT_EQ(
      control_quantity(*parse_quantity("s22 + 2.0e+9 e22", fault), Deformation::logarithmic_strain).deformation(1, 1),
      2e9);
  EXPECT_EQ(
      control_quantity(*parse_quantity("s22 + 2e9*e22", fault), Deformation::logarithmic_strain).deformation(1, 1),
      2e9);
  EXPECT_EQ(control_quantity(*parse_quantity("2 e11", fault), Deformation::logarithmic_strain).deformation(0, 0), 2);
  EXPECT_EQ(control_quantity(*parse_quantity("2e11", fault), Deformation::logarithmic_strain).deformation(0, 0), 2);
  EXPECT_EQ(control_quantity(*parse_quantity("P21", fault), Deformation::logarithmic_strain).stress(1, 0), 1);
  const ControlQuantity volume = control_quantity(*parse_quantity("s11 + 2 lnJ - J", fault), Deformation::gradient);
  EXPECT_EQ(volume.ln_J, 2);
  EXPECT_EQ(volume.J, -1);
  EXPECT_FALSE(volume.is_linear_in_q());
  // the trace of ln U is ln J
  EXPECT_EQ(control_quantity(*parse_quantity("lnJ", fault), Deformation::logarithmic_strain).deformation,
            Tensor(Tensor::Identity()));
  for (const char* wrong : {"", "e11 e22", "e14", "x", "e11 +", "+", "1..2 e11", "e11 + q", "s1"})
    EXPECT_FALSE(parse_quantity(wrong, fault)) << wrong;
}

TEST(PathScene, RefusesWithOneLine) {
  const std::pair<const char*, const char*> cases[] = {
      {"{control: {e11: 0.1}, rowz: 3}", "rowz"},
      {"{type: uniaxial, control: {e11: 0.1}}", "uniaxial_stress"},
      {"{type: uniaxial_stress, control: {e22: 0.1}}", "is driven by a component 11"},
      {"{control: {e11: 0.1, F22: 1}}", "one measure of deformation: e stands beside F"},
      {"{control: {s11: 0.1, P22: 1}}", "one measure of stress: s stands beside P"},
      {"{control: {\"L11 + s11\": 0}}", "cannot stand in one sum"},
      {"{control: {q11: 0}}", "'q11' is no component"},
      {"{control: {e11: {to: 1}}}", "path.control.e11.type: required"},
      {"{control: {e11: {type: ramp}}}", "path.control.e11.to: required"},
      {"{control: {e11: {type: ramp, to: 1, begin: 2, end: 1}}}", "must be behind begin"},
      {"{control: {e11: {type: table, times: [0, 1], values: [0]}}}", "2 times for 1 values"},
      {"{control: {e11: {type: table, times: [0, 2, 1], values: [0, 1, 2]}}}", "times must ascend"},
      {"{control: {e11: {type: table, times: [0, 1, 1, 1], values: [0, 1, 2, 3]}}}", "three values at one time"},
      {"{control: {e11: {type: sine, amplitude: 1, period: 0}}}", "period"},
      {"{control: {e11: {type: file, file: nowhere.csv}}}", "no such file"},
      {"{control: {\"e11 + e22\": 0}}", "5 rows for the 6 components of e"},
      {"{type: triaxial, confinement: 5, initial_stress: [1, 2, 3, 4, 5, 6], control: {e11: 0.1}}",
       "cannot be combined"},
      {"{type: biaxial, confinement: 5, control: {e11: 0.1}}", "belongs to path.type triaxial and"},
      {"{end: 1, control: {e11: {type: ramp, to: 1, begin: 2, end: 3}}}", "the path ends at 1 s"},
      {"{control: {e11: {type: sine, amplitude: 1, period: 1.0e-12}}}", "10000 at most"},
      {"{control: {e11: 1}, stop: {peak: P11}}", "the path is controlled by s"},
      {"{control: {e11: 1}, stop: sometimes}", "loss_of_ellipticity"},
      {"{control: {e11: 1}, stop: {above: {e11: 1, e22: 2}}}", "takes one quantity"},
      {"{control: [e11]}", "path.control"},
      {"{}", "path.control: required"},
      {"{control: {e11: .nan}}", "path.control.e11"},
  };
  for (const auto& [path, said] : cases) {
    const std::string refusal = refusal_of(path);
    EXPECT_NE(refusal.find(said), refusal.npos) << path << "\n" << refusal;
    EXPECT_TRUE(refusal.starts_with("path.yaml:")) << refusal;
    EXPECT_EQ(refusal.find('\n'), refusal.npos);
  }
}

/// What is written reads back to the same, with every row.
TEST(PathScene, ResolvesToItself) {
  const ScratchFolder scratch;
  scratch.write("data.csv", "t,e11,load [kPa]\n0,0,0\n1,0.1,5\n2,0.1,6\n");
  const std::string text = metal +
                           "path:\n  type: triaxial\n  confinement: 3\n  rows: 7\n  end: 2\n"
                           "  control: {e11: {type: file, file: data.csv}}\n"
                           "  stop: [{above: {e11: 0.2}}, {peak: s11}, loss_of_ellipticity]\n"
                           "variants:\n  - {label: softer, parameters: {E: 500}}\n  - {adapter: mooney_rivlin, "
                           "parameters: {c10: 1, c01: 2, bulk_modulus: 3}}\n"
                           "compare: {file: data.csv, y: s11, y_column: load}\n"
                           "expect: {outcome: limit_load, last.s11: {below: 3}}\n";
  const std::string file = scratch / "path.yaml";
  const PathScene once = scene_from(text, file);
  EXPECT_EQ(once.compare->y_of_x.values, (std::vector<double>{0, 5000, 6000}));
  EXPECT_EQ(once.variants[0].material.parameters.at("E"), 500);
  EXPECT_EQ(once.variants[0].material.parameters.at("nu"), 0.3);
  EXPECT_EQ(once.variants[1].material.parameters.size(), 3u);
  const std::string written = resolved_path_yaml(once), again = resolved_path_yaml(scene_from(written, file));
  EXPECT_EQ(written, again);
}

TEST(PathScene, StagesResolveToThemselves) {
  const std::string text =
      metal +
      "stages:\n  - {type: isotropic, initial_stress: [-1, -1, -1, 0, 0, 0], control: {s11: {type: "
      "ramp, to: -5}}}\n  - {type: triaxial, end: 3, control: {F11: 0.9}, stop: {peak: s11}}\n";
  const PathScene once = scene_from(text, "path.yaml");
  ASSERT_EQ(once.later.size(), 1u);
  EXPECT_EQ(once.later[0].end, 3);
  const std::string written = resolved_path_yaml(once);
  EXPECT_EQ(written, resolved_path_yaml(scene_from(written, "path.yaml")));
}

TEST(PathScene, EveryShippedPathReadsBack) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(tree_folder() + "/configs/paths")) {
    if (entry.path().extension() != ".yaml") continue;
    const std::string file = entry.path().string();
    const std::string written = resolved_path_yaml(scene_from(read_bytes(file), file));
    EXPECT_EQ(written, resolved_path_yaml(scene_from(written, file))) << file;
    ++count;
  }
  EXPECT_GE(count, 8);
}

}  // namespace
}  // namespace assay::drivers::test_path_scene
