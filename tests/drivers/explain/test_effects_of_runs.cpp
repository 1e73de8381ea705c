// SPDX-License-Identifier: BSD-3-Clause
// Effects around the steps of a run: what a scene does not call for leaves no file, no figure and no worker.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "bench/effect_scenes.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/problem.hpp"
#include "drivers/simulation/warnings.hpp"
#include "tests/drivers/quiet_run.hpp"
#include "tests/support/built.hpp"
#include "tests/support/counting_material.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_effects_of_runs {
namespace {

/// What a run leaves and finds, with its calls of the material from outside the steps.
struct Around {
  std::set<std::string> files;
  nlohmann::json result;
};

Around run_of(const std::string& effect, bool with) {
  for (const bench::EffectScene& way : bench::effect_scenes(built("materials"))) {
    if (way.effect != effect) continue;
    const ScratchFolder scratch;
    EXPECT_EQ(run(quiet_run(way.scene, scratch / "out", with ? way.with : way.without)), 0);
    Around around{{}, result_in(scratch / "out")};
    for (const auto& entry : std::filesystem::directory_iterator(scratch / "out")) {
      around.files.insert(entry.path().extension().string());
    }
    return around;
  }
  ADD_FAILURE();
  return {};
}

bool profiles(const Around& around, const std::string& name) {
  return std::any_of(around.result["passes"].begin(), around.result["passes"].end(),
                     [&](const nlohmann::json& pass) { return pass["name"] == name; });
}

TEST(LongAroundTheSteps, WhatIsNotCalledForLeavesNoFile) {
  for (const auto& [effect, file] :
       {std::pair{"snapshots", ".vtu"}, std::pair{"pictures", ".png"}, std::pair{"report", ".html"}}) {
    EXPECT_FALSE(run_of(effect, false).files.contains(file)) << file;
    EXPECT_TRUE(run_of(effect, true).files.contains(file)) << file;
  }
  EXPECT_FALSE(profiles(run_of("snapshots", false), "snapshots"));
  EXPECT_TRUE(profiles(run_of("snapshots", true), "snapshots"));
}

TEST(AroundTheSteps, ARunThatIsNotComparedIsNeitherScreenedNorSampled) {
  const Around without = run_of("screening", false), with = run_of("screening", true);
  EXPECT_TRUE(without.result["screen"]["verdict"].is_null());
  EXPECT_EQ(with.result["screen"]["verdict"], "stable");
  EXPECT_FALSE(profiles(without, "error_sampling"));
  EXPECT_TRUE(profiles(with, "error_sampling"));
  // whose calls are those of the steps and no more; and what the screen would have called
  EXPECT_EQ(without.result["work"]["material_calls"], without.result["work"]["particle_steps"]);
  const Problem problem = assemble(read_scene(tree_folder() + "/configs/paper/vortex_cpdi.yaml", bench::plain()), 1);
  const auto material = test_materials::counted(*problem.material);
  screen_of(problem.scene, *material, problem.scene.time.end, true);
  EXPECT_GT(test_materials::counting::points, 0);
}

TEST(AroundTheSteps, TheTractionsAreComparedWhereThatIsAskedFor) {
  EXPECT_TRUE(run_of("traction_table", false).result["tractions"].is_null());
  EXPECT_FALSE(run_of("traction_table", true).result["tractions"].is_null());
}

TEST(OfIsolation, ThereIsNoWorkerWithoutIt) {
  const Around without = run_of("isolation", false), with = run_of("isolation", true);
  EXPECT_FALSE(profiles(without, "isolation"));
  EXPECT_TRUE(profiles(with, "isolation"));
}

}  // namespace
}  // namespace assay::drivers::test_effects_of_runs
