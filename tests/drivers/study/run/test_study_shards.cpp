// SPDX-License-Identifier: BSD-3-Clause
// Shards of a study and studies that share a folder, by the program itself.
#include <gtest/gtest.h>

#include "drivers/study/run/runner.hpp"
#include "tests/drivers/study/study_program.hpp"

namespace assay::drivers::test_study_shards {
namespace {

namespace fs = std::filesystem;

/// Starts all of them, then waits for each; their exit statuses.
std::vector<int> at_once(const SmallStudy& small, const std::vector<std::vector<std::string>>& calls) {
  std::vector<pid_t> children;
  for (std::size_t k = 0; k < calls.size(); ++k)
    children.push_back(start_assay(calls[k], small.scratch / ("said" + std::to_string(k))));
  std::vector<int> statuses;
  for (const pid_t child : children) {
    int status = 0;
    ::waitpid(child, &status, 0);
    statuses.push_back(WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status));
  }
  return statuses;
}

TEST(LongStudyShards, MergedFromOneFolderTheyAreTheWhole) {
  const SmallStudy small;
  ASSERT_EQ(small.run("whole").status, 0);
  const std::vector<int> good{0, 0};
  EXPECT_EQ(at_once(small, {small.words("out", {"--shard", "1/2"}), small.words("out", {"--shard", "2/2"})}), good);
  EXPECT_NE(bytes_of(small.scratch / "said0").find("shard 1/2: 2 cases; when all shards are done: assay study "),
            std::string::npos)
      << bytes_of(small.scratch / "said0");
  EXPECT_FALSE(fs::exists(small.scratch / "out/study.json")) << "the report is left to --merge";
  const auto before = marks_of_cases(small.scratch / "out");
  const Ending merged = small.run("out", {"--merge"});
  EXPECT_EQ(merged.status, 0) << merged.said;
  EXPECT_EQ(marks_of_cases(small.scratch / "out"), before);
  EXPECT_EQ(same_in_every_run(small.scratch / "out"), same_in_every_run(small.scratch / "whole"));
}

TEST(LongStudyShards, MergedFromTwoFoldersTheyAreTheWhole) {
  const SmallStudy small(small_study_text("timing: {repeat: 2, where: {method: CPDI}}\n"));
  ASSERT_EQ(small.run("whole").status, 0);
  ASSERT_EQ(small.run("one", {"--shard", "1/2"}).status, 0);
  const Ending early =
      small.run("early", {"--merge", "--from", small.scratch / "one", "--from", small.scratch / "one"});
  EXPECT_EQ(early.status, 1);
  EXPECT_NE(early.said.find("2 of 4 cases are missing"), std::string::npos) << early.said;
  EXPECT_NE(bytes_of(small.scratch / "early/cases.csv").find(",missing,"), std::string::npos);
  ASSERT_EQ(small.run("two", {"--shard", "2/2"}).status, 0);
  const Ending merged = small.run("out", {"--merge", "--from", small.scratch / "one", "--from", small.scratch / "two"});
  EXPECT_EQ(merged.status, 0) << merged.said;
  EXPECT_EQ(same_in_every_run(small.scratch / "out"), same_in_every_run(small.scratch / "whole"));
}

std::size_t lines_with(const std::string& text, const std::string& words) {
  std::size_t count = 0;
  for (std::size_t at = text.find(words); at != text.npos; at = text.find(words, at + 1)) ++count;
  return count;
}

/// On an empty folder, on one that is finished, and where one of the two goes on: none loses a case to the other.
TEST(LongStudyShards, TwoStudiesInOneFolderShareItsCases) {
  const SmallStudy small;
  const std::vector<int> good{0, 0};
  const std::vector<std::vector<std::string>> second{{}, {}, {"--resume"}};
  for (std::size_t round = 0; round < second.size(); ++round) {
    const auto before = marks_of_cases(small.scratch / "out");
    EXPECT_EQ(at_once(small, {small.words("out"), small.words("out", second[round])}), good) << round;
    const std::string said = bytes_of(small.scratch / "said0") + bytes_of(small.scratch / "said1");
    EXPECT_EQ(said.find("missing"), std::string::npos) << said;
    EXPECT_EQ(lines_with(said, "another study runs in this folder (process "), 1u) << said;
    EXPECT_EQ(lines_with(said, "): they share its cases\n"), 1u) << said;
    const auto after = marks_of_cases(small.scratch / "out");
    EXPECT_EQ(after.size(), 4u);
    if (round == 1) {
      for (const auto& [folder, mark] : before) EXPECT_NE(after.at(folder), mark) << "not run again";
    }
  }
}

/// They would share no case, and one would lose its results to the other.
TEST(StudyShards, AnotherStudyTakesAnotherFolder) {
  const SmallStudy small;
  std::filesystem::create_directories(small.scratch / "out/cases");
  const StudySession first(small.scratch / "out", "one", false, false);
  const StudySession beside(small.scratch / "out", "one", false, false);
  EXPECT_FALSE(beside.begun_by().empty());
  const Ending ending = small.run("out");
  EXPECT_EQ(ending.status, 3) << ending.said;
  EXPECT_EQ(lines_with(ending.said, "choose another one with -o"), 1u) << ending.said;
}

TEST(StudyShards, OneThatComesWhenTheOtherHasGoneIsAlone) {
  const SmallStudy small;
  ASSERT_EQ(small.run("out").status, 0);
  const auto before = marks_of_cases(small.scratch / "out");
  const Ending again = small.run("out");
  EXPECT_EQ(again.status, 0);
  EXPECT_EQ(again.said.find("another study"), std::string::npos) << again.said;
  for (const auto& [folder, mark] : marks_of_cases(small.scratch / "out")) EXPECT_NE(before.at(folder), mark);
}

TEST(StudyShards, NothingToMergeIsSaid) {
  const SmallStudy small;
  const Ending nothing = small.run("out", {"--merge"});
  EXPECT_EQ(nothing.status, 1);
  EXPECT_NE(nothing.said.find("4 of 4 cases are missing"), std::string::npos) << nothing.said;
  const Ending nowhere = small.run("out", {"--merge", "--from", small.scratch / "nowhere"});
  EXPECT_EQ(nowhere.status, 2);
  EXPECT_EQ(std::count(nowhere.said.begin(), nowhere.said.end(), '\n'), 1) << nowhere.said;
}

// Cases 1 and 3, 2 and 4 are the same scenes: with three shards each would otherwise be run by two.
TEST(LongStudyShards, ASceneThatStandsTwiceIsRunOnce) {
  const SmallStudy small([] {
    std::string text = small_study_text();
    text.replace(text.find("method.basis: ugimp"), 19, "method.basis: cpdi");
    return text;
  }());
  ASSERT_EQ(small.run("whole").status, 0);
  EXPECT_EQ(case_folders(small.scratch / "whole").size(), 2U);
  for (const char* shard : {"1/3", "2/3", "3/3"}) {
    const Ending part = small.run(std::string("part") + shard[0], {"--shard", shard});
    EXPECT_EQ(part.status, 0) << part.said;
    const std::size_t expected = shard[0] == '3' ? 0 : 1;
    EXPECT_EQ(marks_of_cases(small.scratch / (std::string("part") + shard[0])).size(), expected) << shard;
  }
  const Ending merged =
      small.run("out", {"--merge", "--from", small.scratch / "part1", "--from", small.scratch / "part2"});
  EXPECT_EQ(merged.status, 0) << merged.said;
  EXPECT_EQ(same_in_every_run(small.scratch / "out"), same_in_every_run(small.scratch / "whole"));
}

// The same shard started three times, as a cluster does that starts a job again: each case is run once.
TEST(LongStudyShards, TheSameShardAtOnceIsRunOnce) {
  const SmallStudy small;
  ASSERT_EQ(small.run("whole").status, 0);
  const auto part = small.words("out", {"--shard", "1/2", "--resume"});
  const std::vector<int> statuses = at_once(small, {part, part, part, small.words("out", {"--shard", "2/2"})});
  EXPECT_EQ(statuses, (std::vector<int>{0, 0, 0, 0})) << bytes_of(small.scratch / "said1");
  EXPECT_EQ(small.run("out", {"--merge"}).status, 0);
  EXPECT_EQ(same_in_every_run(small.scratch / "out"), same_in_every_run(small.scratch / "whole"));
}

// Neither resumes; at the end one may find the other's report being written, or a case that it runs again.
TEST(LongStudyShards, TwoStudiesAtOnceCorruptNothing) {
  const SmallStudy small(small_study_text("timing: {repeat: 2, where: {method: CPDI}}\n"));
  ASSERT_EQ(small.run("whole").status, 0);
  for (int attempt = 0; attempt < 2; ++attempt) {
    const std::vector<int> statuses = at_once(small, {small.words("out"), small.words("out", {"--jobs", "1"})});
    for (std::size_t k = 0; k < 2; ++k) {
      const std::string said = bytes_of(small.scratch / ("said" + std::to_string(k)));
      const bool met = said.find("another run is writing here") != std::string::npos ||
                       said.find("cases are missing") != std::string::npos;
      EXPECT_EQ(statuses[k] != 0, met) << statuses[k] << said;
      EXPECT_EQ(said.find("crashed"), std::string::npos) << said;
    }
  }
  const Ending resumed = small.run("out", {"--resume"});
  EXPECT_EQ(resumed.status, 0);
  EXPECT_NE(resumed.said.find("4 finished cases were kept\n"), std::string::npos) << resumed.said;
  EXPECT_EQ(same_in_every_run(small.scratch / "out"), same_in_every_run(small.scratch / "whole"));
}

TEST(LongStudyShards, TwoMergesAtOnceBothEndWell) {
  const SmallStudy small;
  ASSERT_EQ(small.run("out").status, 0);
  for (int k = 0; k < 3; ++k) {
    const std::vector<std::string> words = small.words("out", {"--merge", "--quiet"});
    const pid_t one = start_assay(words, small.scratch / "one"), other = start_assay(words, small.scratch / "other");
    for (const pid_t child : {one, other}) {
      int status = 0;
      ::waitpid(child, &status, 0);
      EXPECT_EQ(WIFEXITED(status) ? WEXITSTATUS(status) : -1, 0)
          << bytes_of(small.scratch / "one") << bytes_of(small.scratch / "other");
    }
  }
}

}  // namespace
}  // namespace assay::drivers::test_study_shards
