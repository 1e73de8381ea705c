// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/run/runner.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "drivers/system/input_error.hpp"
#include "tests/drivers/scratch_folder.hpp"

namespace assay::drivers::test_runner {
namespace {

namespace fs = std::filesystem;

/// Stands in for the program: notes when it begins and ends, and does what the scene says (a shell script).
/// $1 run, $2 the scene, $4 the folder of results, $6 threads.
constexpr const char* stand_in = R"sh(#!/bin/sh
folder=$(dirname "$0")
mkdir -p "$4"
echo "begin $(basename "$4") threads=$6" >> "$folder/log"
sleep 0.05
out=$4
. "$2"
echo "end $(basename "$4")" >> "$folder/log"
)sh";
constexpr const char* leave_result =
    "echo '{\"outcome\": \"completed\", \"step_cpu_s\": 0.5, \"wall_s\": 1}' > $out/result.json\n";

class RunnerTest : public testing::Test {
 protected:
  void SetUp() override {
    options_.program = scratch_.write("assay.sh", stand_in);
    fs::permissions(options_.program, fs::perms::owner_all);
    plan_.study.timing.repeat = 3;
  }

  PlannedCase& add(const std::string& key, const std::string& script = leave_result) {
    PlannedCase one;
    one.number = plan_.cases.size() + 1, one.key = key, one.label = key, one.yaml = script;
    plan_.cases.push_back(one);
    return plan_.cases.back();
  }
  RunnerSummary run() {
    return run_cases(plan_, store_, options_, [this](const RunnerReport& report) { reports_.push_back(report); });
  }
  std::string log() const { return bytes_of(scratch_ / "log"); }

  /// The largest number of runs at once, by what the stand-in noted.
  int most_at_once() const {
    std::istringstream lines(log());
    int now = 0, most = 0;
    for (std::string line; std::getline(lines, line); most = std::max(most, now)) now += line[0] == 'b' ? 1 : -1;
    return most;
  }

  ScratchFolder scratch_;
  CaseStore store_{scratch_ / "out"};
  Plan plan_;
  RunnerOptions options_;
  std::vector<RunnerReport> reports_;
};
using LongRunnerTest = RunnerTest;

TEST_F(RunnerTest, RunsEveryCaseOnce) {
  for (const char* key : {"a", "b", "c"}) add(key);
  add("a");
  add("").invalid = "it cannot be";
  const RunnerSummary summary = run();
  EXPECT_EQ(summary.run, 3U);
  for (const char* key : {"a", "b", "c"}) EXPECT_EQ(store_.state_of(key), CaseState::finished);
  EXPECT_EQ(log(), "begin a threads=1\nend a\nbegin b threads=1\nend b\nbegin c threads=1\nend c\n");
  EXPECT_EQ(reports_.back().done, 3U);
  EXPECT_EQ(reports_.back().total, 3U);
  EXPECT_DOUBLE_EQ(reports_.back().fraction, 1);
}

TEST_F(RunnerTest, SideBySideUpToTheThreads) {
  for (const char* key : {"a", "b", "c", "d"}) add(key).threads = 2;
  options_.jobs = 4;
  run();
  EXPECT_EQ(most_at_once(), 2) << log();
  EXPECT_NE(log().find("threads=2"), std::string::npos);
  fs::remove(scratch_ / "log");
  options_.jobs = 1;
  run();
  EXPECT_EQ(most_at_once(), 1) << "more threads than jobs: one at a time";
}

TEST_F(RunnerTest, TimedCasesRunAloneAfterTheOthersAndAgain) {
  add("timed").timed = true;
  for (const char* key : {"a", "b", "c", "d"}) add(key);
  options_.jobs = 4;
  run();
  EXPECT_GT(most_at_once(), 1);
  const std::size_t first = log().find("begin timed");
  ASSERT_NE(first, std::string::npos);
  EXPECT_EQ(
      log().substr(first),
      "begin timed threads=1\nend timed\nbegin repeat threads=1\nend repeat\nbegin repeat threads=1\nend repeat\n");
  const ClockReadings clock = store_.read(plan_.cases[0]).clock;
  EXPECT_TRUE(clock.alone);
  EXPECT_EQ(clock.step_s.size(), 3U);
  EXPECT_FALSE(fs::exists(store_.folder_of("timed") / "repeat"));
  EXPECT_FALSE(store_.read(plan_.cases[1]).clock.alone);
}

TEST_F(RunnerTest, ACaseThatTakesLongIsNotRepeated) {
  add("timed").timed = true;
  plan_.study.timing.seconds = 0.01;
  run();
  EXPECT_EQ(store_.read(plan_.cases[0]).clock.step_s.size(), 1U);
}

TEST_F(RunnerTest, ARepeatThatFailsIsNoReading) {
  add("timed",
      std::string(leave_result) + "test -e $0.twice && exit 9; test $(basename $out) = repeat && touch $0.twice\n")
      .timed = true;
  run();
  EXPECT_EQ(store_.read(plan_.cases[0]).clock.step_s.size(), 2U) << log();
  EXPECT_EQ(store_.state_of("timed"), CaseState::finished);
}

TEST_F(RunnerTest, ResumeKeepsWhatIsFinishedAndTriesAgainWhatCrashed) {
  for (const char* key : {"a", "b", "torn"}) add(key);
  add("crash", "test -e $0.mended || kill -ABRT $$\n" + std::string(leave_result));
  EXPECT_EQ(run().run, 4U);
  EXPECT_EQ(store_.state_of("crash"), CaseState::crashed);
  EXPECT_NE(store_.read(plan_.cases[3]).reason.find("134"), std::string::npos);
  scratch_.write("out/cases/torn/result.json", "{}");
  scratch_.write("assay.sh.mended", "");
  options_.resume = true;
  const RunnerSummary again = run();
  EXPECT_EQ(again.run, 2U);
  EXPECT_EQ(again.kept, 2U);
  EXPECT_EQ(again.torn, 1U);
  EXPECT_EQ(store_.state_of("crash"), CaseState::finished);
  EXPECT_EQ(run().kept, 4U);
}

TEST_F(RunnerTest, NoResultAndAStatusAboveOneAreACrash) {
  add("none", "exit 0\n");
  add("bad", std::string(leave_result) + "echo it is so >&2; exit 2\n");
  add("expect", std::string(leave_result) + "exit 1\n");
  run();
  EXPECT_EQ(store_.read(plan_.cases[0]).reason, "the run ended with status 0");
  EXPECT_EQ(store_.read(plan_.cases[1]).reason, "the run ended with status 2: it is so");
  EXPECT_EQ(store_.read(plan_.cases[2]).outcome, "completed") << "an expectation of the scene is no crash";
}

TEST_F(LongRunnerTest, ALimitStopsACase) {
  add("slow", "sleep 100\n");
  add("fast");
  plan_.study.case_seconds = 2;
  options_.jobs = 2;
  run();
  EXPECT_EQ(store_.read(plan_.cases[0]).outcome, "stopped");
  EXPECT_EQ(store_.read(plan_.cases[1]).outcome, "completed");
}

TEST_F(RunnerTest, AFullDiskEndsTheStudyAndLeavesTheCaseUnfinished) {
  add("a");
  add("full", "echo \"$out: cannot be written: No space left on device\" >&2; exit 3\n");
  add("b");
  EXPECT_THROW(run(), SystemError);
  EXPECT_EQ(store_.state_of("a"), CaseState::finished);
  EXPECT_EQ(store_.state_of("full"), CaseState::missing);
  EXPECT_EQ(store_.state_of("b"), CaseState::missing);
}

TEST_F(RunnerTest, ShardsShareTheCases) {
  for (const char* key : {"a", "b", "c", "a", "d"}) add(key);
  std::size_t all = 0;
  for (std::size_t index = 1; index <= 3; ++index) {
    options_.shard = {index, 3};
    all += run().run;
  }
  EXPECT_EQ(all, 4U) << log();
}

TEST_F(RunnerTest, ACaseThatAnotherStudyRunsIsWaitedFor) {
  add("a");
  add("b");
  std::optional<CaseLock> elsewhere(store_.lock(plan_.cases[0]));
  int waits = 0;
  const RunnerSummary summary = run_cases(plan_, store_, options_, [&](const RunnerReport& report) {
    if (!report.waits || ++waits < 3) return;
    EXPECT_EQ(store_.state_of("b"), CaseState::finished) << "the others first";
    store_.begin(plan_.cases[0]);
    scratch_.write("out/cases/a/result.json", "{\"outcome\": \"completed\"}");
    store_.finish(plan_.cases[0], {});
    elsewhere.reset();
  });
  EXPECT_EQ(summary.run, 1U);
  EXPECT_EQ(summary.kept, 1U) << "it was run meanwhile";
  EXPECT_EQ(log().find("begin a"), std::string::npos);
}

TEST_F(RunnerTest, ACaseThatAnotherStudyGaveUpIsRun) {
  add("a");
  std::optional<CaseLock> elsewhere(store_.lock(plan_.cases[0]));
  const RunnerSummary summary = run_cases(plan_, store_, options_, [&](const RunnerReport& report) {
    if (report.waits) elsewhere.reset();
  });
  EXPECT_EQ(summary.run, 1U);
  EXPECT_EQ(store_.state_of("a"), CaseState::finished);
}

}  // namespace
}  // namespace assay::drivers::test_runner
