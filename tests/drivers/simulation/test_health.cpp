// SPDX-License-Identifier: BSD-3-Clause
// The watch sees what is planted, is silent where nothing is wrong, and what it leaves shows the end again.
#include "drivers/simulation/health.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "drivers/findings/findings.hpp"
#include "drivers/scene/expect.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/warnings.hpp"
#include "mpm/simulation.hpp"
#include "tests/drivers/quiet_run.hpp"
#include "tests/drivers/simulation/exact_setup.hpp"
#include "tests/drivers/simulation/first_breakdown.hpp"
#include "tests/support/png.hpp"
#include "tests/support/tree_folder.hpp"
#include "tests/support/vtu_reader.hpp"

namespace assay::drivers::test_health {
namespace {

using mpm::Column;

const std::string watched_scene =
    "motion: {type: vortex, amplitude: {peak: 0.5}}\n"
    "material: {adapter: neo_hookean, parameters: {E: 1e3, nu: 0.3}, density: 1000}\n"
    "body: {domain: ring}\ngrid: {spacing: 0.1}\nmethod: {basis: cpdi}\nforce: {response: closed_form}\n";

/// A run under the watch, without its body force unless that is set.
struct Watched {
  Problem problem = assemble(scene_from_text(watched_scene, "w.yaml", {}), 1);
  mpm::Simulation<2> simulation{with_exact_solution(problem)};
  HealthWatch<2> watch{problem, simulation.state()};
  mpm::State<2>& state() { return simulation.state(); }
  std::optional<mpm::Finding> look(std::int64_t steps = 8, double t = 0.01) {
    return watch.look(state(), steps, t, problem.dt, problem.wave_speed);
  }
};

TEST(HealthWatch, FindsNothingInABodyThatIsWell) {
  Watched run;
  EXPECT_FALSE(run.look());
  EXPECT_TRUE(run.watch.sentences().empty());
  EXPECT_EQ(run.watch.figures().jacobian_min, 1);
  EXPECT_NEAR(*run.watch.figures().domain_extent, std::hypot(0.25, 0.25), 0.1);  // half a particle's diagonal
  EXPECT_LE(*run.watch.figures().courant, 0.4 + 1e-12);
  EXPECT_LE(*run.watch.figures().energy, 1);
}

TEST(HealthWatch, NamesAVelocityThatIsNoNumber) {
  for (const double planted : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    Watched run;
    run.state().column(Column::velocity, 1)[17] = planted;
    const auto found = run.look();
    ASSERT_TRUE(found);
    EXPECT_EQ(found->reason, "the velocity is not a finite number");
    EXPECT_EQ(found->particle, 17);
  }
}

TEST(HealthWatch, SaysWhereEnergyIsBeyondTheRangeOfNumbers) {
  Watched run;
  run.state().column(Column::velocity, 1)[17] = 1e200;
  const auto found = run.look();
  ASSERT_TRUE(found);
  EXPECT_EQ(found->reason, "mass or energy is beyond the range of numbers; fastest");
  EXPECT_EQ(found->particle, 17);
}

TEST(HealthWatch, StopsEnergyThatNoForceHasGiven) {
  Watched run;
  EXPECT_FALSE(run.look(1, 0.001));
  double* u = run.state().column(Column::velocity, 0);
  double square = 0;
  for (std::size_t p = 0; p < run.state().particles; ++p) square += u[p] * u[p];
  const double v0 = std::sqrt(square / static_cast<double>(run.state().particles));
  for (std::size_t p = 0; p < run.state().particles; ++p) u[p] = 5 * v0;
  EXPECT_FALSE(run.look(8, 0.002));  // ten times the speed is asked for: models may make some energy
  for (std::size_t p = 0; p < run.state().particles; ++p) u[p] = 50 * v0;
  u[23] *= 2;
  const auto found = run.look(16, 0.003);
  ASSERT_TRUE(found);
  EXPECT_NE(found->reason.find("times the largest value that the known forces can produce"), std::string::npos);
  EXPECT_EQ(found->particle, 23);
}

TEST(HealthWatch, GrantsWhatTheBodyForceGives) {
  Watched run;
  double *u = run.state().column(Column::velocity, 0), *b = run.state().column(Column::body_force, 0);
  for (std::size_t p = 0; p < run.state().particles; ++p) b[p] = 1e6, u[p] = 0;
  EXPECT_FALSE(run.look(1, 0.001));
  for (std::size_t p = 0; p < run.state().particles; ++p) u[p] = 1e6 * 0.008;
  EXPECT_FALSE(run.look(8, 0.008));
}

TEST(HealthWatch, TellsFastParticlesAndLongDomains) {
  Watched run;
  run.state().column(Column::velocity, 0)[3] = 100;
  run.state().column(Column::deformation_gradient, 1)[5] = 40;
  run.look();
  const auto said = run.watch.sentences();
  ASSERT_EQ(said.size(), 2u);
  EXPECT_NE(said[0].find("100 m/s"), std::string::npos);
  EXPECT_NE(said[1].find("remedies.largest_domain"), std::string::npos);
}

/// uGIMP in the paper's vortex, which it does not live through.
const std::vector<std::string> dying{"method={basis: ugimp}", "grid.spacing=0.1", "output.pictures=false",
                                     "output.particles=0", "output.errors=5"};

TEST(DyingRun, IsToldWhatLivesThroughMore) {
  const auto advice = [](const std::vector<std::string>& sets) {
    return advice_after_death(assemble(scene_from_text(watched_scene, "w.yaml", sets), 1));
  };
  const std::string recommended =
      "method={basis: bspline2, formulation: total, transfer: aflip, mass: series, terms: 4, integrator: leapfrog, ";
  EXPECT_NE(advice({}).find(recommended.substr(8, 60)), std::string::npos) << advice({});
  const auto holds = [](const std::string& text, const std::string& part) { return text.find(part) != text.npos; };
  const std::string left = advice_after_death(
      assemble(scene_from_text(watched_scene, "w.yaml", {"force={response: none}"}), 1), "a particle left the grid");
  EXPECT_TRUE(holds(left, "grid.lower and grid.upper")) << left;
  EXPECT_TRUE(holds(advice({recommended + "courant: 0.8}"}), "(method.courant: 0.4)"));
  EXPECT_EQ(advice({recommended + "courant: 0.4}"}), "");
  EXPECT_TRUE(
      holds(advice({recommended + "courant: 0.4}", "remedies.anti_locking=cell"}), "(remedies.anti_locking: none)"));
}

TEST(DyingRun, LeavesTheLastGoodParticlesAndASceneOfTheEnd) {
  const ScratchFolder scratch;
  std::vector<std::string> shown = dying;
  shown.emplace_back("output.particles=1");
  EXPECT_EQ(run(quiet_run("paper/vortex_cpdi", scratch / "dead", shown)), 1);
  const auto dead = result_in(scratch / "dead");
  ASSERT_EQ(dead["outcome"], "unstable");
  EXPECT_EQ(dead["last_good"], "last_good.vtu");
  EXPECT_EQ(dead["replay"], "replay_scene.yaml");
  const VtuFile good(bytes_of(scratch / "dead/last_good.vtu")), other(bytes_of(scratch / "dead/particles_0000.vtu"));
  EXPECT_EQ(good.names(), other.names());
  const std::vector<double> error = good.array<double>("displacement_error");
  EXPECT_GT(*std::max_element(error.begin(), error.end()), 0);
  EXPECT_LT(*std::max_element(error.begin(), error.end()), 10) << "it was good";
  RunOptions again = quiet_run("paper/vortex_cpdi", scratch / "again", {});
  again.scene = scratch / "dead/replay_scene.yaml";
  again.sets.clear();
  EXPECT_EQ(run(again), 0);  // it expects to die, and does
  const auto replayed = result_in(scratch / "again");
  EXPECT_EQ(replayed["t"], dead["t"]);
  EXPECT_EQ(replayed["reason"], dead["reason"]);
  EXPECT_EQ(replayed["steps"], dead["steps"]);
  int shots = 0;
  for (const auto& file : std::filesystem::directory_iterator(scratch / "again")) {
    shots += file.path().filename().string().starts_with("particles_0") ? 1 : 0;
  }
  EXPECT_NEAR(shots, 20, 1);  // every step of the last twenty
}

TEST(FailedMaterial, IsToldOfALargerToleranceWhereThatMayDo) {
  MaterialFailure failure("its history takes too many steps", 1, 0.5);
  Result refused, slow;
  record_failure(failure, refused);
  EXPECT_EQ(refused.advice, "");
  failure.too_accurate = true;
  record_failure(failure, slow);
  EXPECT_TRUE(slow.advice.starts_with("force.tolerance: 1e-4"));
  EXPECT_EQ(slow.outcome, "material_failed");
}

/// As of a steel that becomes unstable in the first fifth of 150,000 steps.
TEST(DyingRun, LeavesASceneThatAsksForNoMoreSnapshotsThanItMay) {
  const ScratchFolder scratch;
  const Scene scene = scene_from_text(watched_scene, "w.yaml", {});
  Result result;
  result.outcome = "unstable", result.steps = 31093, result.dt = 1 / 150034.0, result.t = 31093 / 150034.0;
  result.sheet.emplace();
  result.sheet->error_tau = 1e-9, result.sheet->error_dtau = 0.06;
  OutputFolder folder(scratch / "out");
  leave_replay_scene(scene, folder, result);
  folder.write("result.json", "{}");
  folder.commit();
  const Scene left = scene_from_text(bytes_of(scratch / "out/replay_scene.yaml"), "r.yaml", {});
  constexpr double most = 1e5;
  EXPECT_LT((left.time.end - *left.output.each_step_from) / *result.dt, most);
  EXPECT_GT(left.time.end, *result.t);
  EXPECT_EQ(left.time.step, result.dt);
  ASSERT_EQ(left.expect.size(), 2u) << "an inaccurate sheet is no news either";
  for (const ExpectationOutcome& outcome : judge(left.expect, result)) EXPECT_TRUE(outcome.holds) << outcome.key;
}

/// At the beginning nothing errs, and the picture has one colour.
TEST(LongDyingRun, ShowsItsLastMomentWithoutSnapshots) {
  const ScratchFolder scratch;
  std::vector<std::string> seen = dying;
  seen.emplace_back("output.pictures=true");
  ASSERT_EQ(run(quiet_run("paper/vortex_cpdi", scratch / "dead", seen)), 1);
  ASSERT_EQ(result_in(scratch / "dead")["outcome"], "unstable");
  int width = 0, height = 0, channels = 0;
  unsigned char* const pixels = stbi_load((scratch / "dead/error.png").c_str(), &width, &height, &channels, 3);
  ASSERT_TRUE(pixels);
  int yellow = 0;  // the end of the map
  for (int i = 0; i < width * height; ++i)
    yellow += pixels[3 * i] > 200 && pixels[3 * i + 1] > 200 && pixels[3 * i + 2] < 90;
  stbi_image_free(pixels);
  EXPECT_GT(yellow, 400) << "more than the bar of colours";
}

/// The last good particles lie before the end, and a history behind the stress does not go back there.
TEST(DyingRun, LeavesTheLastGoodParticlesWhereTheStressIsAHistory) {
  const std::vector<std::pair<std::string, std::vector<std::string>>> deaths{
      {"fluid", {"material.parameters.bulk_modulus=2e103"}},
      {"axis_aligned", {"time={end: 1, step: 0.2}"}},
      {"j2_shadow",
       {"time={end: 1, step: 0.1}", "motion.amplitude.peak=1", "motion.allow_unstable=true", "grid.spacing=0.125",
        "method={basis: ugimp, courant: 1}"}},
  };
  for (const auto& [scene, sets] : deaths) {
    const ScratchFolder scratch;
    RunOptions options = quiet_run("", scratch / "dead", sets);
    options.scene = tree_folder() + "/tests/fuzz/scenes/" + scene + ".yaml";
    options.sets.emplace_back("output={particles: 1, pictures: false}");
    ASSERT_EQ(run(options), 1) << scene;
    EXPECT_EQ(result_in(scratch / "dead")["last_good"], "last_good.vtu") << scene;
    const std::vector<double> error =
        VtuFile(bytes_of(scratch / "dead/last_good.vtu")).array<double>("displacement_error");
    ASSERT_FALSE(error.empty()) << scene;
    for (const double e : error) ASSERT_TRUE(std::isfinite(e)) << scene;
  }
}

TEST(DyingRun, ARunThatReachesItsEndLeavesNeither) {
  const auto result =
      result_of_run("paper/vortex_cpdi", {"grid.spacing=0.1", "time.end=0.02", "output.pictures=false"});
  EXPECT_TRUE(result["last_good"].is_null());
  EXPECT_TRUE(result["replay"].is_null());
}

TEST(DyingRun, IsReportedAtItsFirstInversionOrLostNumber) {
  const std::vector<std::pair<std::string, std::vector<std::string>>> deaths{
      {"paper/vortex_cpdi", dying},
      {"paper/vortex_cpdi", {"method={basis: ugimp, transfer: apic}", "grid.spacing=0.1"}},
      {"methods/best_total", {"grid.spacing=0.1875", "time.step=0.1"}},
      {"methods/best_updated", {"grid.spacing=0.1875", "time.step=0.1"}},
      {"methods/best_updated", {"grid.spacing=0.09375", "material.parameters.nu=0.499", "method.courant=0.8"}},
  };
  constexpr double share_of_run = 0.01;
  for (const auto& [scene, sets] : deaths) {
    const ScratchFolder scratch;
    std::vector<std::string> quiet = sets;
    for (const char* set : {"output.pictures=false", "output.particles=0", "output.errors=5"}) quiet.push_back(set);
    EXPECT_EQ(run(quiet_run(scene, scratch / "out", quiet)), 1);
    const auto result = result_in(scratch / "out");
    EXPECT_EQ(result["outcome"], "unstable") << scene;
    const Breakdown first = first_breakdown(tree_folder() + "/configs/" + scene + ".yaml", quiet);
    EXPECT_NEAR(result["t"].get<double>(), first.t, share_of_run * first.run) << scene << result["reason"];
  }
}

}  // namespace
}  // namespace assay::drivers::test_health
