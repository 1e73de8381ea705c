// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/warnings.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/problem.hpp"
#include "tests/drivers/process.hpp"
#include "tests/drivers/quiet_run.hpp"
#include "tests/drivers/scratch_folder.hpp"
#include "tests/support/built.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_screening {
namespace {

const std::string vortex_scene = tree_folder() + "/configs/paper/vortex_cpdi.yaml";
const std::string jaumann = "material={adapter: hypoelastic_jaumann, parameters: {E: 1e3, nu: 0.3}, density: 1000}";

RunOptions quick_run(const std::string& out, const std::vector<std::string>& more) {
  std::vector<std::string> sets{"grid.spacing=0.125", "force.tolerance=1e-6", jaumann, "time.end=0.1"};
  sets.insert(sets.end(), more.begin(), more.end());
  return quiet_run("paper/vortex_cpdi", out, sets);
}

/// Hypoelasticity loses strong ellipticity at gamma = pi/3; the paper's vortex reaches 7.07 per radian.
constexpr double safe = std::numbers::pi / 3 / 7.0656;

TEST(Screening, AMotionThatIsNoStableSolutionIsRefused) {
  const ScratchFolder scratch;
  const std::string out = scratch / "out";
  EXPECT_EQ(run(quick_run(out, {})), 1);
  const auto result = result_in(out);
  EXPECT_EQ(result["outcome"], "refused");
  EXPECT_TRUE(result["steps"].is_null());
  EXPECT_EQ(result["screen"]["verdict"], "unstable");
  EXPECT_NEAR(std::abs(result["screen"]["gamma"].get<double>()), std::numbers::pi / 3, 1e-2);
  EXPECT_LT(result["screen"]["t"].get<double>(), 0.1);
  EXPECT_LT(result["screen"]["smallest"].get<double>(), 0);
  const std::string reason = result["reason"];
  EXPECT_EQ(reason.find("this motion is not a stable solution for this model at this amplitude"), 0u) << reason;
  EXPECT_NE(reason.find("hypoelastic_jaumann loses strong ellipticity at gamma = -1.0"), std::string::npos) << reason;
  // expected, it is as it should be; the resolved scene and the report are there
  EXPECT_EQ(run(quick_run(out, {"expect={outcome: refused, screen.verdict: unstable}"})), 0);
  EXPECT_TRUE(std::filesystem::exists(out + "/resolved.yaml"));
  EXPECT_TRUE(std::filesystem::exists(out + "/report.html"));
}

TEST(LongScreening, ItsLargestSafeAmplitudeIsRunAndALittleMoreIsNot) {
  const ScratchFolder scratch;
  const std::string out = scratch / "out";
  EXPECT_EQ(run(quick_run(out, {"time.end=1"})), 1);
  const double amplitude = result_in(out)["screen"]["largest_safe_amplitude"];
  EXPECT_NEAR(amplitude, safe, 2e-3 * safe);
  const auto outcome = [&](double peak) {
    run(quick_run(out, {"motion.amplitude.peak=" + std::to_string(peak)}));
    return result_in(out)["outcome"].get<std::string>();
  };
  // over the whole period at the small resolution of this test
  const auto whole = [&](double peak) {
    run(quick_run(out, {"time.end=1", "grid.spacing=0.25", "motion.amplitude.peak=" + std::to_string(peak)}));
    return result_in(out);
  };
  EXPECT_EQ(whole(amplitude)["screen"]["verdict"], "stable");
  EXPECT_EQ(whole(1.01 * amplitude)["outcome"], "refused");
  EXPECT_EQ(outcome(amplitude), "completed");
}

TEST(Screening, CanBeOverruled) {
  const ScratchFolder scratch;
  const std::string out = scratch / "out";
  run(quick_run(out, {"motion.allow_unstable=true", "time.end=0.06"}));
  EXPECT_NE(result_in(out)["outcome"], "refused");
  EXPECT_GT(result_in(out)["steps"].get<long>(), 0);
  EXPECT_EQ(result_in(out)["screen"]["verdict"], "unstable");
}

TEST(Screening, SaysNothingOfAStableMotionButItsFigures) {
  const ScratchFolder scratch;
  const std::string out = scratch / "out";
  EXPECT_EQ(run(quick_run(out, {"material={adapter: neo_hookean, parameters: {E: 1e3}, density: 1000}"})), 0);
  const auto screen = result_in(out)["screen"];
  EXPECT_EQ(screen["verdict"], "stable");
  EXPECT_GT(screen["smallest"].get<double>(), 0.1);
  for (const char* key : {"t", "xi", "gamma", "largest_safe_amplitude"}) EXPECT_TRUE(screen[key].is_null()) << key;
  // without a body force the body does not move as the motion says
  EXPECT_EQ(run(quick_run(out, {"force={response: none}"})), 0);
  EXPECT_TRUE(result_in(out)["screen"]["verdict"].is_null());
}

TEST(LongScreening, EvalAndTabulateWarnAndGoOn) {
  const ScratchFolder scratch;
  const std::string points = scratch.write("points.csv", "X,Y,t\n1.1,0,0.75\n");
  const std::vector<std::string> sets{"--set", jaumann, "--set", "expect={}", "--set", "force.tolerance=1e-6"};
  const auto with = [&](std::vector<std::string> words, const std::string& more) {
    words.insert(words.end(), sets.begin(), sets.end());
    if (!more.empty()) words.insert(words.end(), {"--set", more});
    return assay(words);
  };
  const std::vector<std::vector<std::string>> verbs{{"eval", vortex_scene, "--points", points},
                                                    {"tabulate", vortex_scene, "-o", scratch / "out"}};
  for (const auto& verb : verbs) {
    const Ending warned = with(verb, "");
    EXPECT_EQ(warned.status, 0) << warned.said;
    EXPECT_NE(warned.said.find("warning: this motion is not a stable solution"), std::string::npos) << warned.said;
    for (const char* quiet : {"motion.allow_unstable=true", "motion.amplitude.peak=0.1"}) {
      EXPECT_EQ(with(verb, quiet).said.find("warning"), std::string::npos) << quiet;
    }
  }
  const Ending explained = with({"explain", vortex_scene}, "");
  EXPECT_EQ(explained.status, 0);
  EXPECT_NE(explained.said.find("motion: unstable from gamma = "), std::string::npos) << explained.said;
}

/// A material that ends just beyond the path: stable as far as it was judged, with a warning, and the run goes on.
TEST(LongScreening, WarnsOfPlacesThatItCouldNotJudge) {
  const ScratchFolder scratch;
  const std::string out = scratch / "out", plugin = built("tests/plugins/fails_midway.so");
  const double peak = (0.4 - 4e-5) / 7.0656;  // the material refuses |gamma| > 0.4
  const Ending ending = assay({"run", vortex_scene, "-o", out, "--set", "grid.spacing=0.125", "--set", "expect={}",
                               "--set", "motion.amplitude.peak=" + std::to_string(peak), "--set",
                               "material={adapter: " + plugin + ", density: 1000}"});
  const auto result = result_in(out);
  EXPECT_EQ(result["screen"]["verdict"], "stable");
  EXPECT_GT(result["screen"]["unjudged"].get<int>(), 0);
  EXPECT_NE(ending.said.find("warning: stable as far as it was judged"), std::string::npos) << ending.said;
  EXPECT_NE(ending.said.find("the material fails in small steps from"), std::string::npos) << ending.said;
}

TEST(Screening, SafeAmplitudesAreNeverRoundedUp) {
  ScreenFigures figures;
  figures.verdict = "unstable";
  figures.t = 0.25, figures.xi = -1.5, figures.smallest = -0.1;
  figures.largest_safe_amplitude = 0.148;
  EXPECT_EQ(
      instability_sentence(figures, "clay", {}),
      "this motion is not a stable solution for this model at this amplitude: clay loses strong ellipticity at t = "
      "0.25 s, xi = -1.5; largest safe amplitude 0.148 of the path's (motion.allow_unstable: true overrides)");
  const std::string in_ms = instability_sentence(figures, "clay", {.time = "ms"});
  EXPECT_NE(in_ms.find("at t = 250 ms, xi"), std::string::npos) << in_ms;
  figures.verdict = "neutral";
  EXPECT_EQ(instability_sentence(figures, "water", {}), "");
}

/// Screened at the places of the body alone, which say no amplitude that would be safe.
TEST(Screening, OfARingAndABoxLooksWhereTheBodyIs) {
  const auto screened = [](const std::string& scene, std::vector<std::string> sets) {
    sets.emplace_back("method.courant=0.3");
    Scene given = read_scene(tree_folder() + "/configs/motions/" + scene + ".yaml", sets);
    const Problem problem = assemble(given, 1);
    return screen_of(problem.scene, *problem.material, problem.scene.time.end, true);
  };
  const std::string soft = "material={adapter: saint_venant_kirchhoff, parameters: {E: 1.0e3, nu: 0.3}, density: 1000}";
  EXPECT_EQ(screened("twisting_ring", {"motion.amplitude.peak=0", "motion.expansion=-0.5"}).verdict, "stable");
  EXPECT_EQ(screened("twisting_ring", {soft, "motion.amplitude.peak=0", "motion.expansion=-0.1"}).verdict, "stable");
  const std::string stretched = "body={domain: box, lower: [0, 0.5], upper: [0.5, 1], per_cell: [2, 2]}";
  const std::string pressed = "body={domain: box, lower: [0.5, 0], upper: [1, 0.5], per_cell: [2, 2]}";
  EXPECT_EQ(screened("axis_aligned", {soft, stretched, "motion.amplitude.peak=0.2"}).verdict, "stable");
  const ScreenFigures lost = screened("axis_aligned", {soft, pressed, "motion.amplitude.peak=0.2"});
  EXPECT_EQ(lost.verdict, "unstable");
  EXPECT_FALSE(lost.largest_safe_amplitude);
  EXPECT_EQ(instability_sentence(lost, "soft", {}).find("safe"), std::string::npos);
}

}  // namespace
}  // namespace assay::drivers::test_screening
