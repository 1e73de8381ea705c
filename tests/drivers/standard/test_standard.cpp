// SPDX-License-Identifier: BSD-3-Clause
// The standard set, its runs and its card.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>

#include "drivers/scene/scene_reader.hpp"
#include "drivers/standard/standard_runs.hpp"
#include "drivers/system/whole_file.hpp"
#include "drivers/verbs/verbs.hpp"
#include "tests/drivers/refusal.hpp"
#include "tests/drivers/scratch_folder.hpp"
#include "tests/support/built.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_standard {
namespace {

namespace fs = std::filesystem;

void expect_refused(const std::function<void()>& action, const std::string& key, const std::string& advice) {
  const std::string line = refusal_of(action);
  EXPECT_NE(line.find(key), std::string::npos) << line;
  EXPECT_NE(line.find(advice), std::string::npos) << line;
}

TEST(StandardSet, EveryProblemIsASceneThatStatesWhatItAsksFor) {
  const StandardSet set = standard_set();
  EXPECT_GE(set.problems.size(), 15u);
  std::size_t histories = 0;
  for (const StandardProblem& problem : set.problems) {
    const Scene scene = problem.scene();
    EXPECT_FALSE(scene.expect.empty()) << problem.id;
    ASSERT_GE(problem.grids.size(), 3u) << problem.id;
    EXPECT_TRUE(std::ranges::is_sorted(problem.grids, std::greater())) << problem.id;
    EXPECT_EQ(problem.text, bytes_of(tree_folder() + "/configs/standard/1/" + problem.file()));
    histories += problem.id.ends_with("_history");
  }
  EXPECT_GE(histories, 7u);  // one of each motion
}

TEST(StandardSet, RefusesWhatItDoesNotHave) {
  expect_refused([&] { standard_set(2); }, "--edition", "1 to 1");
  expect_refused([&] { standard_set(1, {"vortex"}); }, "--only", "vortex_mild");
}

/// The lines of a section of a resolved scene.
std::string section_of(const std::string& resolved, const std::string& name) {
  const std::size_t begin = resolved.find("\n" + name + ":");
  if (begin == resolved.npos) return {};
  std::size_t end = resolved.find('\n', begin + 1);
  while (end + 1 < resolved.size() && resolved[end + 1] == ' ') end = resolved.find('\n', end + 1);
  return resolved.substr(begin, end - begin);
}

TEST(StandardSet, AMethodIsTheSameInThePlaneAndInSpace) {
  const StandardSet set = standard_set();
  ASSERT_EQ(set.methods.size(), 2u);
  std::string before;
  for (const StandardMethod& method : set.methods) {
    std::string first;
    std::size_t in_space = 0;
    for (const StandardProblem& problem : set.problems) {
      std::vector<std::string> sets = sets_of(set, method, problem);
      sets.push_back("grid.spacing=" + std::to_string(problem.grids[0]));
      const Scene scene = scene_from_text(problem.text, problem.file(), sets);
      ASSERT_TRUE(scene.method) << problem.id;
      in_space += scene.dimension == 3;
      const std::string found = section_of(resolved_yaml(scene), "method");
      EXPECT_NE(found.find("courant: 0.4"), std::string::npos) << found;
      if (first.empty()) first = found;
      EXPECT_EQ(found, first) << problem.id;
      EXPECT_GE(scene.output.particles, 10) << problem.id;  // what is asked of any code
    }
    EXPECT_EQ(in_space, 3u);
    EXPECT_NE(first, before);
    before = first;
  }
}

TEST(StandardSet, NamesOfGridsAreReadBack) {
  constexpr double six_digits = 5e-6;
  for (const double h : {0.1, 0.025, 1.0 / 6, 2.0}) EXPECT_NEAR(*grid_of_name(folder_of_grid(h)), h, six_digits * h);
  EXPECT_EQ(*grid_of_name("h_0.05.csv"), 0.05);
  EXPECT_EQ(*grid_of_name("run_h0.05.npz"), 0.05);
  EXPECT_FALSE(grid_of_name("scene.yaml"));
  EXPECT_FALSE(grid_of_name("judge.json"));
}

class StandardRun : public testing::Test {
 protected:
  StandardOptions options(const std::string& action, const std::string& out) {
    StandardOptions given;
    given.action = action;
    given.only = {"rotating_stretch"};
    if (action == "judge") given.only.emplace_back("vortex3d");
    given.out = scratch_ / out;
    given.quiet = true;
    given.program = built("assay");
    return given;
  }
  int status_of(const StandardOptions& given) {
    testing::internal::CaptureStdout();
    const int status = standard(given);
    said_ = testing::internal::GetCapturedStdout();
    return status;
  }
  nlohmann::json card(const std::string& out) {
    return nlohmann::json::parse(bytes_of(scratch_ / (out + "/card.json")));
  }
  ScratchFolder scratch_;
  std::string said_;
};
using LongStandardRun = StandardRun;

TEST_F(LongStandardRun, LeavesACardThatAnotherJudgementRepeats) {
  EXPECT_EQ(status_of(options("run", "own")), 0) << said_;
  const auto own = card("own");
  ASSERT_EQ(own["codes"].size(), 2u);
  for (const auto& code : own["codes"]) {
    EXPECT_TRUE(code["rows"][0]["good"]);
    EXPECT_GT(code["rows"][0]["order"], 1.5);
    EXPECT_GT(code["rows"][0]["grids"][0]["core_s"], 0);
    EXPECT_FALSE(code["machine"].is_null());
  }
  for (const char* file : {"card.md", "card.html"})
    EXPECT_GT(bytes_of(scratch_ / ("own/" + std::string(file))).size(), 300u);
  StandardOptions again = options("judge", "again");
  again.folders = {scratch_ / "own/total_b2"};
  EXPECT_EQ(status_of(again), 0) << said_;
  EXPECT_EQ(card("again")["codes"][0]["rows"][0], own["codes"][0]["rows"][0]);
  EXPECT_EQ(card("again")["codes"][0]["rows"][1]["found"], "not run");
  EXPECT_TRUE(card("again")["codes"][0]["rows"][1]["grids"].empty());
}

TEST_F(LongStandardRun, ProblemsInSpaceAreRunAndJudged) {
  StandardSet set = standard_set(1, {"vortex3d_history"});
  for (StandardProblem& problem : set.problems) problem.grids = {0.25, 0.125};  // the edition's take minutes
  for (const StandardMethod& method : set.methods) {
    const CardCode code = run_by(set, method, scratch_ / "space", true, built("assay"));
    ASSERT_EQ(code.rows.size(), 1u);
    for (const CardRow& row : code.rows) {
      ASSERT_EQ(row.grids.size(), 2u) << row.found;
      EXPECT_TRUE(row.causes.empty()) << row.found;
      EXPECT_GT(row.last_order.value_or(0), 1.5) << method.name << ", " << row.id << ": " << row.found;
      EXPECT_LT(row.grids[1].relative.value_or(1), 0.1) << method.name << ", " << row.id << ": " << row.found;
      for (const CardGrid& grid : row.grids) EXPECT_GT(grid.core_s.value_or(0), 0);  // of a completed run alone
    }
  }
}

TEST_F(LongStandardRun, ARunThatEndsEarlyOrIsDamagedIsNotGood) {
  ASSERT_EQ(status_of(options("run", "own")), 0);
  const fs::path run = fs::path(scratch_ / "own") / "cpdi2/rotating_stretch/h_0.0625";
  std::string collection = bytes_of((run / "particles.pvd").string());
  const std::size_t cut = collection.find("<DataSet", collection.size() / 2);
  collection.replace(cut, collection.find("</Collection>") - cut, "");
  write_file(run / "particles.pvd", collection);
  StandardOptions again = options("judge", "again");
  again.folders = {scratch_ / "own/cpdi2"};
  EXPECT_EQ(status_of(again), 1);
  const auto row = card("again")["codes"][0]["rows"][0];
  EXPECT_FALSE(row["good"]);
  EXPECT_EQ(row["causes"], nlohmann::json({"ends_early"}));
}

TEST_F(LongStandardRun, WithoutTheFinestGridIsNotGood) {
  ASSERT_EQ(status_of(options("run", "own")), 0);
  const fs::path problem = fs::path(scratch_ / "own") / "cpdi2/rotating_stretch";
  const auto judged = [&] {
    StandardOptions again = options("judge", "again");
    again.folders = {scratch_ / "own/cpdi2"};
    EXPECT_EQ(status_of(again), 1);
    return card("again")["codes"][0]["rows"][0];
  };
  double finest = 1;
  for (const auto& each : fs::directory_iterator(problem)) {
    if (const auto h = grid_of_name(each.path().filename().string())) finest = std::min(finest, *h);
  }
  const fs::path grid = problem / folder_of_grid(finest);
  fs::remove_all(grid);
  auto row = judged();
  EXPECT_FALSE(row["good"]);
  EXPECT_EQ(std::string(row["found"]).find("the finest grid, h = "), 0u) << row["found"];
  // an export that was not run is no grid
  fs::create_directory(grid);
  write_file(grid / "seeds.csv", "id,X,Y\n1,0,0\n");
  EXPECT_EQ(judged(), row);
}

TEST_F(StandardRun, AFolderWithoutResultsIsRefused) {
  StandardOptions given = options("judge", "card");
  given.folders = {scratch_ / "."};
  expect_refused([&] { standard(given); }, "", "ID/h_0.1");
  given.folders.clear();
  expect_refused([&] { standard(given); }, "FOLDER", "needs folders");
}

}  // namespace
}  // namespace assay::drivers::test_standard
