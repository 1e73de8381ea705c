// SPDX-License-Identifier: BSD-3-Clause
// Temperature and other fields of a path's scene.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "drivers/check/replay.hpp"
#include "drivers/path/path_scene.hpp"
#include "drivers/path/path_tabulation.hpp"
#include "drivers/verbs/verbs.hpp"
#include "tests/drivers/process.hpp"
#include "tests/drivers/refusal.hpp"
#include "tests/drivers/scratch_folder.hpp"
#include "tests/support/built.hpp"

namespace assay::drivers::test_path_fields {
namespace {

constexpr double alpha = 1e-4, tolerance = 1e-10;

std::string thermal(const std::string& interface) { return built("tests/foreign/") + interface + "_thermal.so"; }

/// Of the behaviour of MFront's interface, or of the UMAT with its description.
std::string material_of(const std::string& interface, const ScratchFolder& scratch) {
  if (interface == "mfront")
    return "material: {adapter: '" + thermal(interface) +
           "', parameters: {YoungModulus: 1000, PoissonRatio: 0.3, Expansion: 1.0e-4}}\n";
  const std::string file = scratch.write(
      interface + ".yaml", "library: " + thermal(interface) + "\ninterface: " + interface +
                               "\nproperties: {E: 1000, nu: 0.3, alpha: 1.0e-4}\nstate: {warm: scalar, swollen: "
                               "scalar}\ntemperature: 20\nfields: {swelling: 0}\n");
  return "material: {adapter: '" + file + "'}\n";
}

struct Found {
  int status = -1;
  nlohmann::json last;
};

Found tabulated(const std::string& interface, const std::string& path) {
  const ScratchFolder scratch;
  scratch.write("oven.csv", "t [s];T [C]\n0;20\n1;120\n2;70\n");
  TabulateOptions options;
  options.scene = scratch.write("path.yaml", material_of(interface, scratch) + "path: " + path + "\n");
  options.out = scratch / "out";
  options.verbosity = Verbosity::quiet;
  Found found;
  found.status = tabulate(options);
  found.last = nlohmann::json::parse(bytes_of(options.out + "/result.json"))["last"];
  options.scene = options.out + "/resolved.yaml", options.out = scratch / "again";
  EXPECT_EQ(tabulate(options), found.status) << "resolved.yaml";
  EXPECT_EQ(nlohmann::json::parse(bytes_of(options.out + "/result.json"))["last"], found.last) << "resolved.yaml";
  return found;
}

std::string refused(const std::string& path, const std::string& interface = "mfront") {
  return refusal_of([&] { tabulated(interface, path); });
}

TEST(LongPathFields, StrainAFreePoint) {
  const Found found = tabulated(
      "mfront", "{control: {s11: 0, s22: 0, s33: 0}, fields: {Temperature: {type: ramp, from: 300, to: 400}}}");
  EXPECT_EQ(found.status, 0);
  EXPECT_NEAR(found.last["e22"].get<double>(), 100 * alpha, tolerance * 100 * alpha);
  EXPECT_EQ(found.last["Temperature"].get<double>(), 400);
}

TEST(LongPathFields, BeginAtTheirOwnValueAndEndAtThatOfAFile) {
  const Found found = tabulated(
      "umat", "{control: {s11: 0, s22: 0, s33: 0}, fields: {temperature: {type: file, file: oven.csv, column: T}}}");
  EXPECT_EQ(found.status, 0);
  EXPECT_NEAR(found.last["e11"].get<double>(), 50 * alpha, tolerance * 100 * alpha);
  EXPECT_NEAR(found.last["t"].get<double>(), 2, 0);
}

TEST(LongPathFields, AreThoseOfTheDescription) {
  const Found found = tabulated("vumat", "{control: {e11: 0}, fields: {swelling: {type: ramp, from: 0, to: 0.01}}}");
  EXPECT_EQ(found.status, 0);
  EXPECT_NEAR(found.last["s11"].get<double>(), -1000 / 0.4 * 0.01, tolerance * 1000);
  EXPECT_NEAR(found.last["swollen"].get<double>(), 0.01, tolerance);
}

TEST(PathFields, AreRefusedWithALine) {
  const std::string heated = "{control: {e11: 0}, fields: {";
  EXPECT_NE(refused(heated + "Temperature: {type: ramp, to: 400}}}").find("needs from"), std::string::npos);
  EXPECT_NE(refused(heated + "Temperature: {type: table, times: [0, 1, 1, 2], values: [1, 1, 2, 2]}}}")
                .find("jumps at t = 1 s"),
            std::string::npos);
  const std::string unknown = refused(heated + "Humidity: 1}}");
  EXPECT_NE(unknown.find("path.fields.Humidity: "), std::string::npos) << unknown;
  EXPECT_NE(unknown.find("Temperature, Swelling"), std::string::npos) << unknown;
  const std::string of_umat = refused(heated + "Temperature: 1}}", "umat");
  EXPECT_NE(of_umat.find("temperature, swelling"), std::string::npos) << of_umat;
  EXPECT_NE(refused("{control: {e11: 0}, fields: 3}").find("path.fields"), std::string::npos);
}

TEST(PathFields, AreRefusedByAModelThatTakesNone) {
  const ScratchFolder scratch;
  TabulateOptions options;
  options.scene = scratch.write("path.yaml",
                                "material: {adapter: neo_hookean, parameters: {E: 1, nu: 0.3}}\n"
                                "path: {control: {e11: 0}, fields: {temperature: 300}}\n");
  options.out = scratch / "out";
  const std::string said = refusal_of([&] { tabulate(options); });
  EXPECT_NE(said.find("path.yaml:2:"), std::string::npos) << said;
  EXPECT_NE(said.find("path.fields.temperature: material 'neo_hookean' has no field of that name; known: none"),
            std::string::npos)
      << said;
}

/// The parts of a function meet within rounding, and a field has no more periods than a row may have.
TEST(LongPathFields, TakeWavesAsRowsDo) {
  EXPECT_EQ(tabulated("mfront",
                      "{control: {s11: 0}, end: 0.3, fields: {Temperature: {type: cycles, sizes: [1, 2, 3], "
                      "period: 0.1}}}")
                .status,
            0);
  EXPECT_NE(refused("{control: {s11: 0}, fields: {Temperature: {type: sine, amplitude: 1, period: 1.0e-12}}}")
                .find("path.fields.Temperature.period"),
            std::string::npos);
  EXPECT_NE(
      refused("{control: {s11: 0}, end: 1, fields: {Temperature: {type: ramp, from: 0, to: 1, begin: 2, end: 3}}}")
          .find("path.fields.Temperature.begin"),
      std::string::npos);
}

std::string refused_description(const std::string& text) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("m.yaml", text);
  const std::string scene =
      "material: {adapter: '" + file + "'}\npath: {type: uniaxial_stress, control: {e11: 0.001}}\n";
  TabulateOptions options;
  options.scene = scratch.write("path.yaml", scene), options.out = scratch / "out";
  options.verbosity = Verbosity::quiet;
  return refusal_of([&] { tabulate(options); });
}

TEST(PathFields, AValueThatNobodyGivesIsRefused) {
  EXPECT_NE(refused_description("library: " + thermal("mfront") + "\ninterface: mfront\nvarying: [YoungModulus]\n")
                .find("m.yaml:3:11: varying.YoungModulus: `properties` must give its value"),
            std::string::npos);
  EXPECT_NE(refused_description("library: " + thermal("umat") +
                                "\ninterface: umat\nproperties: {E: 1000, nu: 0.3, alpha: 1.0e-4}\nfields: "
                                "{temperature: 0}\n")
                .find("m.yaml:4:23: fields.temperature: is no field here: the key `temperature` says it"),
            std::string::npos);
}

/// A model that ends its process where it is hot: the step that is left has the temperature at both of its ends.
void expect_the_same_end(const std::string& adapter, const ScratchFolder& scratch) {
  TabulateOptions options;
  options.scene = scratch.write("path.yaml", "material: {adapter: '" + adapter +
                                                 "', isolation: worker}\n"
                                                 "path: {control: {e11: {type: ramp, to: 0.01}}, fields: {temperature: "
                                                 "{type: ramp, from: 293, to: 393}}}\n");
  options.out = scratch / "out";
  options.verbosity = Verbosity::quiet;
  EXPECT_EQ(tabulate(options), 1);
  const std::string file = options.out + "/replay.yaml", text = bytes_of(file);
  const Replay replay = read_replay(file);
  ASSERT_EQ(replay.step->fields1.size(), 1u) << text;
  EXPECT_LE(replay.step->state0.back(), 350);
  EXPECT_GE(replay.step->fields1[0], 350);
  EXPECT_NEAR(replay.step->fields1[0], 293 + 100 * (replay.step->t + replay.step->dt), 1e-9);
  const Ending again = assay({"check", "--replay", file});
  EXPECT_EQ(again.status, 1) << again.said;
  EXPECT_NE(again.said.find("signal 6"), std::string::npos) << again.said;
  std::string cooler = text;
  cooler.replace(cooler.find("fields1:"), std::string::npos, "fields1:\n  temperature: 340\nreason: none\n");
  EXPECT_EQ(assay({"check", "--replay", scratch.write("cooler.yaml", cooler)}).status, 0);
  cooler.replace(cooler.find("  temperature: 340"), 13, "  humidity");
  EXPECT_EQ(assay({"check", "--replay", scratch.write("other.yaml", cooler)}).status, 2);
}

TEST(LongPathFields, AreInTheStepOfAReplay) {
  const ScratchFolder scratch;
  expect_the_same_end(scratch.write("hot.yaml", "library: " + built("tests/foreign/umat_crashes_when_hot.so") +
                                                    "\ninterface: umat\nproperties: {E: 1000, nu: 0.3, alpha: "
                                                    "0}\ntemperature: 293\n"),
                      scratch);
  expect_the_same_end(built("tests/plugins/crashes_when_hot.so"), scratch);
}

}  // namespace
}  // namespace assay::drivers::test_path_fields
