// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/check/replay.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "drivers/system/input_error.hpp"
#include "tests/drivers/foreign_checks.hpp"
#include "tests/drivers/process.hpp"
#include "tests/drivers/quiet_run.hpp"
#include "tests/drivers/refusal.hpp"
#include "tests/drivers/registry_fixture.hpp"
#include "tests/drivers/scene_text.hpp"
#include "tests/drivers/scratch_folder.hpp"

namespace assay::drivers::test_replay {
namespace {

std::string fails_when_sheared() {
  return "material={adapter: " + plugins + "fails_when_sheared.so, parameters: {modulus: 1000}, density: 1000}";
}

RunOptions quick_run(const std::string& out, const std::vector<std::string>& more) {
  std::vector<std::string> sets{"grid.spacing=0.125", "motion.allow_unstable=true"};
  sets.insert(sets.end(), more.begin(), more.end());
  return quiet_run("paper/vortex_cpdi", out, sets);
}

/// Taken again the step fails with the same words; of a smaller one it does not.
void expect_the_same_failure(const std::string& folder, const std::string& words) {
  const Replay replay = read_replay(folder + "/replay.yaml");
  const Material material = std::move(resolved_of(replay).material);
  const UpdateReport report = take_again(material, *replay.step);
  EXPECT_EQ(report.worst, ASSAY_FAILED);
  EXPECT_EQ(report.message, words);
  EXPECT_NE(replay.reason.find(words), std::string::npos);
  EXPECT_EQ(replay.library_sha256.size(), 64u);
  FailedStep smaller = *replay.step;
  smaller.F1 = Tensor::Identity() + 0.01 * (smaller.F1 - Tensor::Identity());
  EXPECT_NE(take_again(material, smaller).worst, ASSAY_FAILED);
}

TEST(LongReplay, OfARunIsLeftBeforeAndDuringTheSteps) {
  const ScratchFolder scratch;
  const std::string out = scratch / "out";
  EXPECT_EQ(run(quick_run(out, {fails_when_sheared()})), 1);
  EXPECT_EQ(nlohmann::json::parse(bytes_of(out + "/result.json"))["replay"], "replay.yaml");
  expect_the_same_failure(out, "deformed beyond its limit");
  EXPECT_EQ(run(quick_run(out, {fails_when_sheared(), "motion.amplitude.peak=0.055"})), 1);
  const auto result = nlohmann::json::parse(bytes_of(out + "/result.json"));
  ASSERT_GT(result["steps"].get<long>(), 0);
  expect_the_same_failure(out, "deformed beyond its limit");
  const Replay replay = read_replay(out + "/replay.yaml");
  EXPECT_NEAR(replay.step->t + replay.step->dt, result["t"].get<double>(), 1e-12);
  // F0 is the step's own, though this material looks at F1 alone
  EXPECT_LT((replay.step->F1 - replay.step->F0).norm(), 0.1 * (replay.step->F1 - Tensor::Identity()).norm());
  EXPECT_NE(bytes_of(out + "/report.html").find("replay.yaml"), std::string::npos);
  // a run that does not fail leaves none, and takes the old one away
  EXPECT_EQ(run(quick_run(out, {"time.end=0.05"})), 0);
  EXPECT_FALSE(std::filesystem::exists(out + "/replay.yaml"));
  EXPECT_TRUE(nlohmann::json::parse(bytes_of(out + "/result.json"))["replay"].is_null());
}

/// A model with memory that cannot go on in the middle of a sheet, by its word or by NaN: the place, the step that
/// fails again, and nothing in the cache.
TEST(LongReplay, OfAHistoryThatFailsMidwayNamesThePlaceAndCachesNothing) {
  const ScratchFolder scratch;
  const char* before = std::getenv("ASSAY_CACHE_HOME");
  const std::string home = before ? before : "", cache = scratch / "cache", out = scratch / "out";
  ::setenv("ASSAY_CACHE_HOME", cache.c_str(), 1);
  const auto kept = [&] { return std::filesystem::exists(cache) && !std::filesystem::is_empty(cache + "/sheets"); };
  const auto material = [](const char* modulus, const char* peak) {
    return std::vector<std::string>{
        "material={adapter: " + plugins + "fails_midway.so, parameters: {modulus: " + modulus + "}, density: 1000}",
        std::string("motion.amplitude.peak=") + peak};
  };
  for (const char* modulus : {"1000", "900"}) {
    EXPECT_EQ(run(quick_run(out, material(modulus, "0.2"))), 1);
    const auto result = nlohmann::json::parse(bytes_of(out + "/result.json"));
    EXPECT_EQ(result["outcome"], "material_failed");
    EXPECT_NE(result["reason"].get<std::string>().find("on the baseline path at xi = "), std::string::npos);
    EXPECT_EQ(result["replay"], "replay.yaml");
    const Replay replay = read_replay(out + "/replay.yaml");
    EXPECT_GT(replay.step->t + replay.step->dt, 0);
    EXPECT_LT(replay.step->t + replay.step->dt, 0.5);  // on the way up
    EXPECT_GT(std::abs(replay.step->F1(1, 0)), 4e-4 * std::stod(modulus));
    EXPECT_EQ(take_again(resolved_of(replay).material, *replay.step).worst, ASSAY_FAILED);
    EXPECT_FALSE(kept()) << modulus;
  }
  EXPECT_EQ(run(quick_run(out, material("1000", "0.02"))), 0);
  EXPECT_TRUE(kept());  // where it does not fail, it is
  before ? ::setenv("ASSAY_CACHE_HOME", home.c_str(), 1) : ::unsetenv("ASSAY_CACHE_HOME");
}

TEST(Replay, OfATabulationIsLeftAndEvalNamesTheCommandThatDoes) {
  const ScratchFolder scratch;
  const std::string out = scratch / "out", scene = scratch.write("scene.yaml", scene_text());
  EXPECT_EQ(assay({"tabulate", scene, "-o", out, "--set", fails_when_sheared()}).status, 1);
  expect_the_same_failure(out, "deformed beyond its limit");
  const std::string points = scratch.write("points.csv", "X,Y,t\n1.1,0,0.75\n");
  const Ending ending = assay({"eval", scene, "--points", points, "--set", fails_when_sheared()});
  EXPECT_EQ(ending.status, 1);
  EXPECT_NE(ending.said.find("deformed beyond its limit"), std::string::npos);
  EXPECT_NE(ending.said.find("`assay tabulate " + scene), std::string::npos) << ending.said;
  EXPECT_NE(ending.said.find("--set time.end=0.75` leaves the step in a replay.yaml"), std::string::npos);
}

/// Bit for bit, values that are no numbers too; the state by the names of its variables.
TEST(Replay, IsReadAsItWasWritten) {
  Replay replay;
  replay.material = "hypoelastic_jaumann";
  replay.parameters = {{"E", 1.0 / 3}, {"nu", 0.1 + 0.2}};
  replay.step.emplace();
  replay.step->t = 1.0 / 7;
  replay.step->dt = 1e-300;
  replay.step->F0 = Tensor::Random();
  replay.step->F1 = Tensor::Random();
  replay.step->state0 = {1.0 / 3, -0.0, std::nan(""), std::numeric_limits<double>::infinity(), 5e-324, -1e308};
  replay.reason = "what: it said, on\ntwo lines";
  const ScratchFolder scratch;
  keep_yaml("plain", replay_yaml(replay));
  const Replay back = read_replay(scratch.write("replay.yaml", replay_yaml(replay)));
  EXPECT_EQ(back.material, replay.material);
  EXPECT_EQ(back.parameters, replay.parameters);
  EXPECT_EQ(back.step->t, replay.step->t);
  EXPECT_EQ(back.step->dt, replay.step->dt);
  EXPECT_EQ(back.step->F0, replay.step->F0);
  EXPECT_EQ(back.step->F1, replay.step->F1);
  ASSERT_EQ(back.step->state0.size(), 6u);
  for (std::size_t k = 0; k < 6; ++k) {
    if (k == 2)
      EXPECT_TRUE(std::isnan(back.step->state0[k]));
    else
      EXPECT_EQ(back.step->state0[k], replay.step->state0[k]) << k;
  }
  EXPECT_EQ(back.reason, "what: it said, on two lines");
  EXPECT_EQ(back.library_sha256, "");
}

TEST(Replay, RefusesWhatIsNone) {
  const ScratchFolder scratch;
  Replay replay;
  replay.material = "hypoelastic_jaumann";
  replay.parameters = {{"E", 1e3}, {"nu", 0.3}};
  replay.step.emplace().state0.assign(6, 0.0);
  replay.step->dt = 1;
  const std::string good = replay_yaml(replay);
  const auto refusal = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    text.replace(text.find(from), from.size(), to);
    return refusal_of([&] { read_replay(scratch.write("replay.yaml", text)); });
  };
  EXPECT_EQ(refusal("t: 0", "t: 0"), "accepted");
  EXPECT_NE(refusal("stress: [0, 0, 0, 0, 0, 0]", "stress: [0, 0]").find("state0.stress: must be a list of 6"),
            std::string::npos);
  EXPECT_NE(refusal("stress:", "strain:").find("strain: unknown key"), std::string::npos);
  EXPECT_NE(refusal("F0: [[1, 0, 0]", "F0: [[1, 0]").find("F0"), std::string::npos);
  EXPECT_NE(refusal("dt: 1", "dt: soon").find("dt: must be a number"), std::string::npos);
  EXPECT_NE(refusal("dt: 1", "dt: -1").find("dt: must be above 0"), std::string::npos);
  EXPECT_NE(refusal("t: 0", "t: 0\ntest: rotation.durin").find("rotation.during"), std::string::npos);
  EXPECT_NE(refusal("hypoelastic_jaumann", "nothing").find("nothing"), std::string::npos);
}

/// A description that finds its library by $ASSAY_MATERIAL_PATH, as in a test of ctest, is found again without it.
TEST(LongReplay, KeepsTheFoldersOfLibraries) {
  if (!has_foreign("umat_kinematic")) GTEST_SKIP() << "no Fortran compiler";
  const ScratchFolder scratch;
  const std::string description = scratch.write(
      "model.yaml",
      "library: umat_kinematic.so\ninterface: umat\nflags: [non_smooth]\nstate: 7\nmaterial_name: UNTURNED\n"
      "properties: {E: 1.0e3, nu: 0.3, yield: 10, C: 50}\n");
  const auto in_folder = [] { ::setenv("ASSAY_MATERIAL_PATH", built("tests/foreign").c_str(), 1); };
  const auto without = [] { ::unsetenv("ASSAY_MATERIAL_PATH"); };
  const Ending check = assay({"check", description, "--quick", "-o", scratch / "r"}, in_folder);
  ASSERT_EQ(check.status, 1) << check.said;
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(scratch / "r")) files.push_back(entry.path().string());
  ASSERT_FALSE(files.empty()) << check.said;
  EXPECT_NE(bytes_of(files.front()).find("material_path: "), std::string::npos) << bytes_of(files.front());
  const Ending again = assay({"check", "--replay", files.front()}, without);
  EXPECT_EQ(again.status, 1) << again.said;
  EXPECT_EQ(again.said.find("no such library"), std::string::npos) << again.said;
}

/// As one from a CI server, whose library lies elsewhere here.
TEST(LongReplay, TakesAnotherMaterialInPlaceOfItsOwn) {
  const ScratchFolder scratch;
  const std::string library = scratch / "moved.so";
  std::filesystem::copy(plugins + "fails_when_sheared.so", library);
  const Ending check =
      assay({"check", library, "--parameters", "modulus=1000", "--quick", "--strain", "0.4", "-o", scratch / "r"});
  ASSERT_EQ(check.status, 1) << check.said;
  const std::string file = std::filesystem::directory_iterator(scratch / "r")->path().string();
  std::filesystem::remove(library);
  EXPECT_EQ(assay({"check", "--replay", file}).status, 2);
  const Ending again = assay({"check", plugins + "fails_when_sheared.so", "--replay", file});
  EXPECT_EQ(again.status, 1) << again.said;
  EXPECT_EQ(assay({"check", "--methods", "--replay", file}).status, 2);
}

}  // namespace
}  // namespace assay::drivers::test_replay
