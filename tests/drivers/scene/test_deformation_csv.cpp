// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include "drivers/scene/scene_reader.hpp"
#include "harness/motion/kinds/deformation_table.hpp"
#include "tests/drivers/refusal.hpp"
#include "tests/drivers/scratch_folder.hpp"

namespace assay::drivers::test_deformation_csv {
namespace {

TEST(DeformationCsv, ReadsPlaneAndFullGradients) {
  const ScratchFolder scratch;
  const DeformationTable plane = read_deformation_table(
      scratch.write("p.csv", "F22,t,F11,F12,F21\n1,0,1,0,0\n.9,2,1.1,.2,0\n"), Interpolation::linear);
  EXPECT_TRUE(plane.plane());
  EXPECT_EQ(plane.last(), 2);
  EXPECT_NEAR(plane.at({}, 1).F(0, 1), 0.1, 1e-15);
  const DeformationTable full = read_deformation_table(
      scratch.write("f.csv", "t,F11,F12,F13,F21,F22,F23,F31,F32,F33\n0,1,0,0,0,1,0,0,0,1\n1,1,0,.3,0,1,0,0,.1,1.2\n"),
      Interpolation::linear);
  EXPECT_FALSE(full.plane());
  EXPECT_NEAR(full.at({}, 1).F(0, 2), 0.3, 1e-15);
}

TEST(DeformationCsv, RefusesWhatIsNoPath) {
  const ScratchFolder scratch;
  const std::string header = "t,F11,F12,F21,F22\n", rest = "0,1,0,0,1\n";
  const auto line = [&](const std::string& text) {
    const std::string file = scratch.write("p.csv", text);
    return refusal_of([&] { read_deformation_table(file, Interpolation::spline); }).substr(file.size());
  };
  EXPECT_EQ(line(header + "0.1,1,0,0,1\n1,1,0,0,1\n"), ":2:1: t: the first row must be at t = 0, found 0.1");
  EXPECT_EQ(line(header + "0,1,0.1,0,1\n1,1,0,0,1\n"), ":2:1: the first row must be the undeformed state, F = I");
  EXPECT_EQ(line(header + rest), ":2:1: a path needs two rows at least");
  EXPECT_EQ(line(header + rest + "1,1,0,0,1\n1,1,0,0,1\n"), ":4:1: t: times must ascend, found 1 after 1");
  EXPECT_EQ(line(header + rest + "1e-300,1,0,0,1\n1,1,0,0,1\n"),
            ":3:1: t: rows may not lie closer than 1e-12 of the whole, found 1e-300 after 0");
  EXPECT_EQ(line(header + rest + "1e-300,1.1,0,0,1\n"),
            ":3:1: t: a time of 1e-300 s between rows leaves no number for their acceleration");
  EXPECT_EQ(line(header + rest + "1,1,0,0,1\n1.0000000000000002,1,0,0,1\n").find(":4:1: t: rows may not lie"), 0u);
  EXPECT_EQ(line(header + rest + "1,-1,0,0,1\n"), ":3:1: det F <= 0 in this row, at t = 1");
  EXPECT_EQ(line(header + rest + "1,.05,0,0,1\n2,.05,0,0,1\n3,1,0,0,1\n"),
            ":4:1: det F <= 0 between this row and the one before, at t = 1.5: the spline swings beyond its rows; "
            "motion.interpolation: monotone does not");
  EXPECT_EQ(line("t,F11,F12,F21,F22,F13\n0,1,0,0,1,0\n1,1,0,0,1,0\n"),
            ":1:1: F13, F23, F31 and F32 only come together");
  EXPECT_EQ(line(header + rest + "1,1,x,0,1\n"), ":3:5: F12: 'x' is no finite number");
}

TEST(DeformationCsv, ServesASceneAndItsResolvedForm) {
  const ScratchFolder scratch;
  scratch.write("p.csv", "t,F11,F12,F21,F22\n0,1,0,0,1\n1.5,1.1,.2,0,1\n");
  const std::string text =
      "motion: {type: homogeneous, path: p.csv}\nmaterial: {adapter: neo_hookean, parameters: {E: 1e3}, density: 1}\n";
  const auto scene_with = [&](std::vector<std::string> sets) {
    return scene_from_text(text, scratch / "scene.yaml", sets);
  };
  const Scene scene = scene_with({});
  EXPECT_EQ(scene.time.end, 1.5);
  EXPECT_EQ(scene.motion->period(), 1.5);
  const std::string resolved = resolved_yaml(scene);
  EXPECT_EQ(resolved_yaml(scene_from_text(resolved, "elsewhere.yaml")), resolved);
  const auto line = [&](const std::string& set) { return refusal_of([&] { scene_with({set}); }); };
  EXPECT_EQ(line("motion.period=2"),
            "--set motion.period: is the time of the last row of motion.path, 1.5 s: leave it out");
  EXPECT_EQ(line("time.end=2"), "--set time.end: must not exceed the last time of motion.path, 1.5, found 2");
  EXPECT_EQ(line("motion.final=[[1, 0, 0], [0, 1, 0], [0, 0, 1]]"),
            "--set motion.final: cannot be combined with motion.path, which gives F at all times");
  EXPECT_NE(line("motion.path=nowhere.csv").find("--set motion.path: no such file: '"), std::string::npos);
  EXPECT_NE(line("motion={type: homogeneous}").find("motion.final: required and not given"), std::string::npos);
  EXPECT_NE(
      line("motion={type: rotating_stretch, stretch: 0.1, axis: [0, 0, 0]}").find("motion.axis: must not be zero"),
      std::string::npos);
}

TEST(DeformationCsv, IsInterpolatedAsTheSceneOrTheVerbSays) {
  const ScratchFolder scratch;
  scratch.write("p.csv", "t,F11,F12,F21,F22\n0,1,0,0,1\n.5,1.1,0,0,1\n1,1.1,0,0,1\n");
  const std::string text =
      "motion: {type: homogeneous, path: p.csv}\nmaterial: {adapter: neo_hookean, parameters: {E: 1e3}, density: 1}\n";
  const auto of = [&](const std::vector<std::string>& sets, Interpolation otherwise) {
    const Scene scene = scene_from_text(text, scratch / "scene.yaml", sets, otherwise);
    return scene.motion.as<DeformationTable>()->interpolation();
  };
  EXPECT_EQ(of({}, to_run), Interpolation::monotone);
  EXPECT_EQ(of({}, to_tabulate), Interpolation::linear);
  EXPECT_EQ(of({"motion.interpolation=spline"}, to_run), Interpolation::spline);
  EXPECT_EQ(of({"motion.interpolation=spline"}, to_tabulate), Interpolation::spline);
  const Scene tabulated = scene_from_text(text, scratch / "scene.yaml", {}, to_tabulate);
  EXPECT_NE(resolved_yaml(tabulated).find("  interpolation: linear\n"), std::string::npos);
  const auto line = [&](const std::vector<std::string>& sets) { return refusal_of([&] { of(sets, to_run); }); };
  EXPECT_EQ(line({"motion.interpolation=cubic"}),
            "--set motion.interpolation: unknown value 'cubic'; known: linear, monotone, spline");
  EXPECT_EQ(line({"motion={type: homogeneous, interpolation: linear, final: [[1, 0, 0], [0, 1, 0], [0, 0, 1]]}"}),
            "--set motion.interpolation: sets F between the rows of a table, so it needs motion.path");
  EXPECT_NE(line({"motion={type: vortex, interpolation: linear}"}).find("does not belong to motion.type vortex"),
            std::string::npos);
}

/// Between the rows det F is positive or not by what is between them.
TEST(DeformationCsv, LooksForDetFBetweenTheRowsAsTheyAreInterpolated) {
  const ScratchFolder scratch;
  const std::string file =
      scratch.write("p.csv", "t,F11,F12,F21,F22\n0,1,0,0,1\n1,.05,0,0,1\n2,.05,0,0,1\n3,1,0,0,1\n");
  EXPECT_FALSE(refusal_of([&] { read_deformation_table(file, Interpolation::spline); }).empty());
  for (const Interpolation kind : {Interpolation::linear, Interpolation::monotone}) {
    EXPECT_NEAR(read_deformation_table(file, kind).smallest_determinant().value, 0.05, 1e-15);
  }
}

}  // namespace
}  // namespace assay::drivers::test_deformation_csv
