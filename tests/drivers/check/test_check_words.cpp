// SPDX-License-Identifier: BSD-3-Clause
// How `check` names its input, and how long its tests take.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "drivers/check/check_report.hpp"
#include "drivers/check/replay.hpp"
#include "tests/drivers/process.hpp"
#include "tests/drivers/refusal.hpp"
#include "tests/drivers/registry_fixture.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_check_words {
namespace {

std::string refused(const std::vector<std::string>& words) {
  std::vector<std::string> all{"check"};
  all.insert(all.end(), words.begin(), words.end());
  const Ending ending = assay(all);
  EXPECT_EQ(ending.status, 2) << ending.said;
  return ending.said;
}

TEST(CheckWords, ErrorsNameOptionsAndNoKeysOfAScene) {
  EXPECT_TRUE(refused({"nobody"}).starts_with("unknown material 'nobody'; known: "));
  EXPECT_EQ(refused({"./no.so"}).substr(0, 15), "no such file: '");
  EXPECT_TRUE(refused({"neo_hookean", "--parameters", "E=-1"}).starts_with("--parameters: E: must lie from "));
  EXPECT_TRUE(refused({"neo_hookean", "--parameters", "mu=1"})
                  .starts_with("--parameters: mu: material 'neo_hookean' has no such parameter (nearest: nu)"));
  EXPECT_TRUE(refused({tree_folder() + "/configs/paper/vortex_cpdi.yaml", "--parameters", "nu=0.7"})
                  .starts_with("--parameters: nu: must lie from "));
}

TEST(CheckWords, ErrorsOfASceneAndOfAReplayAreAtTheirPlace) {
  const ScratchFolder scratch;
  const std::string scene = scratch.write(
      "s.yaml", "motion: {type: vortex}\nmaterial: {adapter: neo_hookean, parameters: {E: -1}, density: 1}\n");
  EXPECT_TRUE(refused({scene}).starts_with(scene + ":2:50: material.parameters.E: must lie from ")) << refused({scene});
  const std::string replay =
      scratch.write("r.yaml",
                    "material: nobody\nparameters: {}\nF0: [[1, 0, 0], [0, 1, 0], [0, 0, 1]]\nt: 0\ndt: 1\n"
                    "F1: [[1, 0, 0], [0, 1, 0], [0, 0, 1]]\nstate0: {}\n");
  EXPECT_TRUE(refused({"--replay", replay}).starts_with(replay + ":1:11: material: unknown material 'nobody'"));
}

TEST(CheckWords, EveryTestHasItsWallTime) {
  const ScratchFolder scratch;
  const std::string json = scratch / "c.json", junit = scratch / "c.xml";
  ASSERT_EQ(assay({"check", "neo_hookean", "--quick", "--json", json, "--junit", junit, "-o", scratch / "out"}).status,
            0);
  const auto found = nlohmann::json::parse(bytes_of(json));
  double sum = 0;
  for (const auto& test : found["tests"]) {
    sum += test["wall_s"].get<double>();
    const bool timed = test["verdict"] == "pass" && test["id"] != "calls.process" && test["id"] != "loading";
    EXPECT_TRUE(!timed || test["wall_s"] > 0) << test["id"];
  }
  EXPECT_GT(sum, 0);
  EXPECT_LE(sum, found["wall_s"].get<double>());
  const std::string xml = bytes_of(junit);
  EXPECT_EQ(xml.find("name=\"rotation.during\" time=\"0\""), xml.npos) << xml;
  EXPECT_NE(xml.find("name=\"rotation.during\" time=\"0."), xml.npos) << xml;
}

TEST(CheckWords, AReplayStatesTheUnitsOfItsParameters) {
  Replay replay{"neo_hookean", {{"E", 1e3}, {"nu", 0.3}}, {}, FailedStep{}, "no reason"};
  replay.step->dt = 1;
  replay.step->F0.setIdentity();
  replay.step->F1.setIdentity();
  EXPECT_NE(replay_yaml(replay).find("# Times in s, stresses in Pa, as the parameters.\n"), std::string::npos)
      << replay_yaml(replay);
  EXPECT_EQ(replay_yaml(replay).find("SI units"), std::string::npos);
}

TEST(CheckWords, AReplayOfAForeignModelSaysWhatItsDescriptionSays) {
  const ScratchFolder scratch;
  const std::string umat = built("tests/foreign/umat_neo_hookean.so");
  if (!std::filesystem::exists(umat)) GTEST_SKIP() << "no Fortran compiler";
  const auto words = [&](const std::string& units) {
    const std::string file =
        scratch.write("m.yaml", "library: " + umat + "\ninterface: umat\nproperties: {E: 1, nu: 0.3}\n" + units);
    Replay replay{file, {{"E", 1}, {"nu", 0.3}}, {}, {}, "no reason"};
    replay.test = "rotation.during";
    return replay_yaml(replay);
  };
  EXPECT_NE(words("").find("# Times and stresses in the units that the parameters imply.\n"), std::string::npos);
  EXPECT_NE(words("units: {stress: MPa}\n").find("# Times in s, stresses in Pa, STATEV in the model's own units.\n"),
            std::string::npos);
}

}  // namespace
}  // namespace assay::drivers::test_check_words
