// SPDX-License-Identifier: BSD-3-Clause
// Maps of names, units and times; files of runs.
#include <gtest/gtest.h>

#include <filesystem>

#include "drivers/judge/judged_run.hpp"
#include "tests/drivers/refusal.hpp"
#include "tests/drivers/scratch_folder.hpp"

namespace assay::drivers::test_judge_map {
namespace {

using Names = std::vector<std::string>;

class JudgeMaps : public testing::Test {
 protected:
  JudgeMap map(const std::string& text) { return read_judge_map(scratch_.write("map.yaml", text)); }
  void expect_refused(const std::string& text, const Names& words) {
    const std::string line = refusal_of([&] { map(text); });
    for (const std::string& word : words) EXPECT_NE(line.find(word), std::string::npos) << line;
  }
  ScratchFolder scratch_;
};

TEST_F(JudgeMaps, AreReadWithUnits) {
  const JudgeMap read =
      map("code: mine\nid: tag\nX: [x0, y0]\nx: pos\nsigma: [a, b, c]\nsigma_components: [11, 22, 12]\n"
          "units: {length: mm, time: ms, stress: MPa}\ncost: {seconds: [1, 2.5], cores: 4, machine: M}\n"
          "time: {pattern: 'p_(\\d+)', step: 0.5, velocity: -0.25}\n");
  EXPECT_EQ(read.code, "mine");
  EXPECT_EQ(read.names(Judged::X), (Names{"x0", "y0"}));
  EXPECT_EQ(read.names(Judged::x), Names{"pos"});
  EXPECT_EQ(read.sigma_components, (std::vector<int>{11, 22, 12}));
  EXPECT_EQ(read.length, 1e-3);
  EXPECT_EQ(read.time_unit, 1e-3);
  EXPECT_EQ(read.stress, 1e6);
  EXPECT_EQ(read.cost.seconds, (std::vector<double>{1, 2.5}));
  EXPECT_EQ(read.time.from, JudgeTime::From::name);
}

TEST_F(JudgeMaps, RefuseWhatTheyDoNotKnow) {
  expect_refused("postion: x\n", {"map.yaml:1", "postion", "x"});
  expect_refused("units: {length: miles}\n", {"units.length", "mm"});
  expect_refused("sigma_components: [11, 44]\n", {"sigma_components", "11, 22"});
  expect_refused("time: {from: list}\n", {"from: list needs values"});
  expect_refused("time: {from: step}\n", {"from: step needs step"});
  expect_refused("cost: {seconds: 0}\n", {"cost.seconds", "above 0"});
}

TEST_F(JudgeMaps, PresetsAreMaps) {
  for (const std::string& name : judge_presets()) {
    const JudgeMap read = read_judge_map(name);
    EXPECT_FALSE(read.code.empty());
    EXPECT_FALSE(read.names(Judged::x).empty() && read.names(Judged::u).empty()) << name;
  }
}

TEST_F(JudgeMaps, TimesComeFromNamesColumnsStepsAndLists) {
  std::filesystem::create_directory(scratch_ / "run");
  for (const int k : {2, 10, 1}) {
    scratch_.write("run/p_" + std::to_string(k) + ".csv",
                   "id,x,y\n1," + std::to_string(k) + ",0\n2," + std::to_string(k) + ",1\n");
  }
  scratch_.write("run/notes.md", "not particles");
  const auto times = [&](const std::string& text) {
    std::vector<double> found;
    for (const JudgedFrame& frame : read_judged_run(scratch_ / "run", map(text)).frames) {
      found.push_back(frame.t);
      EXPECT_EQ(frame.size(), 2u);
    }
    return found;
  };
  EXPECT_EQ(times("time: {from: name, pattern: 'p_(\\d+)', step: 0.5}\n"), (std::vector<double>{0.5, 1, 5}));
  EXPECT_EQ(times("time: {from: list, values: [0, 1, 2]}\nunits: {time: ms}\n"), (std::vector<double>{0, 1e-3, 2e-3}));
  EXPECT_EQ(times("time: {from: step, step: 0.5}\n"), (std::vector<double>{0, 0.5, 1}));
  EXPECT_EQ(times("time: {from: column, column: x}\n"), (std::vector<double>{1, 2, 10}));
  const std::string line = refusal_of([&] { times("code: a\n"); });
  EXPECT_NE(line.find("says no time"), std::string::npos) << line;
}

TEST_F(JudgeMaps, LengthsAreInMetres) {
  scratch_.write("run.csv", "t,id,X,Y,ux,uy,vx,vy\n0,1,1000,0,0,0,5,0\n2,1,1000,0,100,0,5,0\n");
  const JudgedRun run = read_judged_run(scratch_ / "run.csv", map("units: {length: mm, time: ms}\n"));
  ASSERT_EQ(run.frames.size(), 2u);
  EXPECT_EQ(run.frames[1].t, 2e-3);
  EXPECT_DOUBLE_EQ(run.frames[1].x[0].x(), 1.1);
  EXPECT_DOUBLE_EQ(run.frames[1].v[0].x(), 5);  // mm/ms
}

TEST_F(JudgeMaps, DigitsAreThoseOfTheFileThatShowsMost) {
  std::filesystem::create_directory(scratch_ / "digits");
  scratch_.write("digits/p_0.csv", "id,X,Y,x,y\n1,1475,-25,1475,-25\n2,1425,25,1425,25\n");
  scratch_.write("digits/p_1.csv", "id,X,Y,x,y\n1,1475,-25,1475.123456,-25.654321\n2,1425,25,1425.25,25.5\n");
  const std::string times = "time: {from: name, pattern: 'p_(\\d+)', step: 1}\nunits: {length: mm}\n";
  EXPECT_NEAR(read_judged_run(scratch_ / "digits", map(times)).rounding, 0.5e-9, 1e-12);  // of 1e-6 mm
  scratch_.write("digits/p_1.csv", "id,X,Y,x,y\n1,1475,-25,1475.1,-25.6\n2,1425,25,1425.2,25.5\n");
  EXPECT_NEAR(read_judged_run(scratch_ / "digits", map(times)).rounding, 0.5e-4, 1e-7);
}

TEST_F(JudgeMaps, VectorsHaveThreeComponentsInSpace) {
  const auto read = [&](const std::string& header, int dimension) {
    std::string row = "0";
    for (std::size_t c = 1; c < std::size_t(1 + std::ranges::count(header, ',')); ++c) row += ",1";
    scratch_.write("run.csv", header + "\n" + row + "\n");
    return refusal_of([&] { read_judged_run(scratch_ / "run.csv", map("code: a\n"), dimension); });
  };
  for (const auto& [header, flat] : {std::pair{"t,id,X,Y,x,y", "X"},
                                     {"t,id,X,Y,Z,x,y", "x"},
                                     {"t,id,x,y,z,vx,vy", "v"},
                                     {"t,id,X,Y,Z,ux,uy", "u"}}) {
    EXPECT_NE(read(header, 3).find(std::string(flat) + ": has two components, and the scene has three dimensions"),
              std::string::npos)
        << header << ": " << read(header, 3);
    EXPECT_EQ(read(header, 2), "accepted") << header;
  }
  EXPECT_EQ(read("t,id,X,Y,Z,x,y,z,vx,vy,vz", 3), "accepted");
}

TEST_F(JudgeMaps, EachRunHasItsOwnSeeds) {
  const auto seeds_of_run = [&](const std::string& run, const std::string& seeds) {
    const JudgedRun read =
        read_judged_run(scratch_ / run, map("time: {from: column, column: t}\nseeds: " + seeds + "\n"));
    return read_seeds(read.map.seeds, read.map).X[0].x();
  };
  for (const char* folder : {"h_1", "h_2", "h_2/out"}) std::filesystem::create_directory(scratch_ / folder);
  for (const char* run : {"h_1/out.csv", "h_2/out/a.csv", "alone.csv"}) scratch_.write(run, "t,id,x,y\n0,1,5,0\n");
  scratch_.write("h_1/seeds.csv", "id,X,Y\n1,10,0\n");
  scratch_.write("h_2/seeds.csv", "id,X,Y\n1,20,0\n");
  EXPECT_EQ(seeds_of_run("h_1/out.csv", "seeds.csv"), 10);
  EXPECT_EQ(seeds_of_run("h_2/out", "seeds.csv"), 20);
  EXPECT_EQ(seeds_of_run("h_2/out/a.csv", "seeds.csv"), 20);
  EXPECT_EQ(seeds_of_run("alone.csv", scratch_ / "h_2/seeds.csv"), 20);
  EXPECT_EQ(seeds_of_run("alone.csv", "h_1/seeds.csv"), 10);
  const std::string line = refusal_of([&] { seeds_of_run("alone.csv", "seeds.csv"); });
  EXPECT_NE(line.find("seeds: seeds.csv lies neither"), std::string::npos) << line;
}

}  // namespace
}  // namespace assay::drivers::test_judge_map
