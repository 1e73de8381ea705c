// SPDX-License-Identifier: BSD-3-Clause
// Tables of F through all that reads them.
#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

#include "drivers/scene/scene_reader.hpp"
#include "drivers/simulation/problem.hpp"
#include "drivers/simulation/response_source.hpp"
#include "drivers/simulation/warnings.hpp"
#include "drivers/verbs/verbs.hpp"
#include "tests/drivers/process.hpp"
#include "tests/drivers/quiet_run.hpp"
#include "tests/drivers/refusal.hpp"
#include "tests/drivers/scratch_folder.hpp"

namespace assay::drivers::test_interpolation {
namespace {

const std::string stretched_and_held =
                      "t,F11,F12,F21,F22\n0,1,0,0,1\n.1,1.05,0,0,1\n.2,1.05,0,0,1\n.6,1.05,0,0,1\n"
                      "1,1.05,0,0,1\n",
                  triangle = "t,F11,F12,F21,F22\n0,1,0,0,1\n.2,1.01,0,0,1\n1,1,0,0,1\n",
                  sheared_on_unequal_rows =
                      "t,F11,F12,F21,F22\n0,1,0,0,1\n.02,1,.04,0,1\n.5,1,.04,0,1\n.53,1,0,0,1\n"
                      "1,1,-.02,0,1\n",
                  two_rows = "t,F11,F12,F21,F22\n0,1,0,0,1\n1,1.02,.01,0,1\n",
                  held_then_a_ramp = "t,F11,F12,F21,F22\n0,1,0,0,1\n.3,1,0,0,1\n.4,1,0,0,1\n1,1.03,0,0,.98\n";

const std::string j2 = "j2_jaumann, parameters: {E: 2e11, nu: 0.3, yield_stress: 2.5e8, hardening_modulus: 1e9}",
                  neo_hookean = "neo_hookean, parameters: {E: 1e3, nu: 0.3}";

std::string scene_of(const std::string& material) {
  return "motion: {type: homogeneous, path: p.csv}\nmaterial: {adapter: " + material +
         ", density: 1000}\nforce: {tolerance: 1e-4, cache: false}\n";
}

const std::string runnable =
    "body: {domain: box, lower: [0, 0], upper: [1, 0.5], per_cell: [2, 2]}\n"
    "grid: {spacing: 0.25}\nmethod: {basis: linear, courant: 0.4}\n"
    "traction: {algorithm: virtual_stress, form: follower}\n"
    "output: {particles: 0, report: false, pictures: false}\n";

/// The response of J2 plasticity to the rows.
std::shared_ptr<const Response> response_to(const std::string& rows, Interpolation kind) {
  const ScratchFolder scratch;
  scratch.write("p.csv", rows);
  Scene scene = scene_from_text(scene_of(j2), scratch / "s.yaml", {}, kind);
  std::string library;
  const auto material = material_of(scene, library);
  return response_of(scene, material, baseline_path(scene), scene.time.end, {.quiet = true});
}

TEST(Interpolation, ASheetOfAnyTableReachesItsTolerance) {
  for (const std::string& rows : {stretched_and_held, triangle, sheared_on_unequal_rows, two_rows, held_then_a_ramp}) {
    const auto response = response_to(rows, to_tabulate);
    EXPECT_LT(response->sheet()->error_tau(), 1e-4) << rows;
    EXPECT_LT(response->sheet()->error_dtau(), 1e-3) << rows;
    EXPECT_LT(response->sheet()->points(), 60000) << rows;
  }
}

/// While F is held nothing happens to a model without a rate.
TEST(Interpolation, StressIsHeldWhereFIsHeld) {
  for (const Interpolation kind : {Interpolation::linear, Interpolation::monotone}) {
    const auto response = response_to(stretched_and_held, kind);
    Tensor at_end, slope;
    response->at(1, 1, at_end, slope);
    for (int k = 0; k < 90; ++k) {
      Tensor tau;
      response->at(1, 0.1 + 0.01 * k, tau, slope);
      EXPECT_LT((tau - at_end).norm(), 1e-4 * at_end.norm()) << static_cast<int>(kind) << " at " << k;
    }
  }
}

/// What `assay tabulate` of the rows writes down.
nlohmann::json tabulated(const std::string& rows, const std::vector<std::string>& sets) {
  const ScratchFolder scratch;
  scratch.write("p.csv", rows);
  TabulateOptions options;
  options.scene = scratch.write("s.yaml", scene_of(neo_hookean));
  options.out = scratch / "out";
  options.sets = sets;
  options.verbosity = Verbosity::quiet;
  EXPECT_EQ(tabulate(options), 0);
  return result_in(options.out);
}

TEST(Interpolation, ASplineThatSwingsIsWarnedOf) {
  const ScratchFolder scratch;
  const auto warned = [&](const std::string& rows, const std::string& kind) {
    scratch.write("p.csv", rows);
    return swing_sentence(scene_from_text(scene_of(neo_hookean), scratch / "s.yaml", {"motion.interpolation=" + kind}));
  };
  EXPECT_EQ(
      warned(stretched_and_held, "spline"),
      "motion.interpolation: the spline takes F11 to 1.04487 at t = 0.36906 s, 0.00513 beyond the rows there, 1.05 and "
      "1.05: monotone stays between them");
  const std::string of_triangle = warned(triangle, "spline");
  EXPECT_EQ(
      of_triangle,
      "motion.interpolation: the spline takes F11 to 1.01562 at t = 0.5 s, 0.00562 beyond the rows there, 1 and 1.01: "
      "monotone stays between them");
  EXPECT_EQ(warned(sheared_on_unequal_rows, "spline"),
            "motion.interpolation: the spline takes F12 to -0.274837 at t = 0.810255 s, 0.255 beyond the rows there, "
            "-0.02 and "
            "0: monotone stays between them");
  EXPECT_EQ(warned(two_rows, "spline"), "");
  for (const std::string& kind : {std::string("linear"), std::string("monotone")}) {
    EXPECT_EQ(warned(stretched_and_held, kind), "");
  }
  const auto warnings = tabulated(triangle, {"motion.interpolation=spline"})["warnings"];
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0], of_triangle);
  scratch.write("p.csv", triangle);
  const Scene run =
      scene_from_text(scene_of(neo_hookean) + runnable, scratch / "s.yaml", {"motion.interpolation=spline"});
  EXPECT_EQ(warnings_of(assemble(run, 1)), (std::vector<std::string>{of_triangle}));
}

TEST(Interpolation, RunAndEvalRefuseWhatHasNoBodyForce) {
  const ScratchFolder scratch;
  scratch.write("p.csv", triangle);
  const std::string scene = scratch.write("s.yaml", scene_of(neo_hookean) + runnable);
  const std::string refusal =
      "--set motion.interpolation: linear makes the velocity jump at the rows, but the body force needs the second "
      "derivative of F: only tabulate accepts linear; known: monotone, spline";
  RunOptions to_run;
  to_run.scene = scene, to_run.out = scratch / "out", to_run.verbosity = Verbosity::quiet;
  to_run.sets = {"motion.interpolation=linear"};
  EXPECT_EQ(refusal_of([&] { run(to_run); }), refusal);
  EXPECT_FALSE(std::filesystem::exists(to_run.out));
  EvalOptions to_eval;
  to_eval.scene = scene, to_eval.points = scratch.write("points.csv", "X,Y,t\n.5,.5,.6\n");
  to_eval.out = scratch / "exact.csv", to_eval.sets = to_run.sets;
  EXPECT_EQ(refusal_of([&] { eval(to_eval); }), refusal);
  ExplainOptions to_explain;
  to_explain.scene = scene, to_explain.sets = to_run.sets;
  EXPECT_EQ(refusal_of([&] { explain(to_explain); }), refusal);
}

/// `run` and `eval` are told of a held stretch, and the body rests then.
TEST(Interpolation, ARunFollowsHeldRows) {
  const ScratchFolder scratch;
  scratch.write("p.csv", stretched_and_held);
  RunOptions options;
  options.scene = scratch.write("s.yaml", scene_of(neo_hookean) + runnable);
  options.out = scratch / "out", options.verbosity = Verbosity::quiet;
  const auto relative = [&](const std::string& step) {
    options.sets = {"time.step=" + step};
    EXPECT_EQ(run(options), 0);
    return result_in(options.out)["error"]["relative"].get<double>();
  };
  const double coarse = relative("0.005");
  const std::string warning = result_in(options.out)["warnings"].dump();
  EXPECT_NE(warning.find("the body force jumps at the rows of motion.path, by up to 15 /s^2 in F''"), std::string::npos)
      << warning;
  EXPECT_NEAR(relative("0.0025") / coarse, 0.5, 0.1) << "of first order in the step";
  EXPECT_NE(bytes_of(options.out + "/resolved.yaml").find("  interpolation: monotone\n"), std::string::npos);
  EvalOptions to_eval;
  to_eval.scene = options.scene, to_eval.points = scratch.write("points.csv", "X,Y,t\n1,.5,.1\n1,.5,.3\n1,.5,.77\n");
  to_eval.out = scratch / "exact.csv";
  ASSERT_EQ(eval(to_eval), 0);
  const std::string exact = bytes_of(to_eval.out);
  std::istringstream lines(exact);
  std::string line;
  std::getline(lines, line);
  EXPECT_TRUE(line.starts_with("X,Y,t,x,y,vx,vy,ax,ay,")) << line;
  for (const char* t : {"0.1", "0.3", "0.77"}) {
    std::getline(lines, line);
    EXPECT_TRUE(line.starts_with(std::string("1,0.5,") + t + ",1.05,0.5,0,0,0,0,1.05,0,0,1,1")) << line;
  }
}

}  // namespace
}  // namespace assay::drivers::test_interpolation
