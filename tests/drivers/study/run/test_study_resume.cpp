// SPDX-License-Identifier: BSD-3-Clause
// A study that is ended from outside, at any time, and resumed.
#include <gtest/gtest.h>

#include <random>

#include "tests/drivers/study/study_program.hpp"

namespace assay::drivers::test_study_resume {
namespace {

namespace fs = std::filesystem;

/// Starts the study in a process group of its own.
pid_t start_in_group(const SmallStudy& small, const std::string& out, const std::vector<std::string>& more) {
  const pid_t child = start_assay(small.words(out, more), small.scratch / "said", [] { ::setpgid(0, 0); });
  ::setpgid(child, child);
  return child;
}

int status_of_child(pid_t child) {
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// The marks that were there and are not the same now.
std::vector<std::string> run_again(const std::map<std::string, std::string>& before,
                                   const std::map<std::string, std::string>& after) {
  std::vector<std::string> changed;
  for (const auto& [folder, mark] : before) {
    const auto found = after.find(folder);
    if (found == after.end() || found->second != mark) changed.push_back(folder);
  }
  return changed;
}

/// Kills the study 20 times after times of 0 to 300 ms, the whole group or the parent alone, then lets it finish.
void kill_and_resume(const SmallStudy& small, const std::string& out, unsigned seed) {
  std::mt19937 random(seed);
  for (int k = 0; k < 20; ++k) {
    const auto before = marks_of_cases(small.scratch / out);
    const pid_t child = start_in_group(small, out, {"--resume", "--quiet", "--jobs", "2"});
    ::usleep(random() % 300000);
    ::kill(k % 2 == 0 ? child : -child, SIGKILL);
    const int status = status_of_child(child);
    EXPECT_TRUE(status == 128 + SIGKILL || status == 0) << status << ": " << bytes_of(small.scratch / "said");
    // Every second time the next one starts at once, while the cases of the last one may still be dying.
    if (k % 4 < 2) {
      EXPECT_TRUE(all_gone(small.scratch / out)) << "a case survived";
    }
    EXPECT_EQ(run_again(before, marks_of_cases(small.scratch / out)), std::vector<std::string>{}) << "kill " << k;
    if (k % 7 == 6) fs::remove_all(small.scratch / out);  // or all would soon be finished
  }
  EXPECT_TRUE(all_gone(small.scratch / out));
}

TEST(LongStudyResume, KilledTwentyTimesItFindsTheSame) {
  const SmallStudy small(small_study_text("timing: {repeat: 2, seconds: 1, where: {method: CPDI}}\n"));
  ASSERT_EQ(small.run("undisturbed").status, 0);
  kill_and_resume(small, "killed", 12345);
  const auto before = marks_of_cases(small.scratch / "killed");
  const Ending last = small.run("killed", {"--resume"});
  EXPECT_EQ(last.status, 0) << last.said;
  EXPECT_EQ(run_again(before, marks_of_cases(small.scratch / "killed")), std::vector<std::string>{});
  EXPECT_EQ(same_in_every_run(small.scratch / "killed"), same_in_every_run(small.scratch / "undisturbed"));
}

TEST(LongStudyResume, CasesOfAnotherKeyAreNotTakenAndThatIsSaid) {
  const SmallStudy small;
  ASSERT_EQ(small.run("out").status, 0);
  EXPECT_EQ(small.run("out", {"--merge"}).said.find("are missing"), std::string::npos);
  const fs::path first = case_folders(small.scratch / "out").front();
  fs::rename(first, first.parent_path() / std::string(32, 'f'));
  const std::string warning = "warning: cases are missing, and 1 finished one belongs to another key";
  const Ending merged = small.run("out", {"--merge"});
  EXPECT_EQ(merged.status, 1);
  EXPECT_NE(merged.said.find(warning), std::string::npos) << merged.said;
  const Ending resumed = small.run("out", {"--resume"});
  EXPECT_EQ(resumed.status, 0);
  EXPECT_NE(resumed.said.find(warning), std::string::npos) << resumed.said;
  EXPECT_EQ(small.run("out", {"--merge"}).said.find("are missing"), std::string::npos) << "nothing is missing any more";
}

TEST(LongStudyResume, FinishedCasesAreKeptAndThatIsSaid) {
  const SmallStudy small;
  ASSERT_EQ(small.run("out").status, 0);
  const auto before = marks_of_cases(small.scratch / "out");
  const auto found = same_in_every_run(small.scratch / "out");
  ASSERT_EQ(before.size(), 4U);
  const Ending kept = small.run("out", {"--resume"});
  EXPECT_EQ(kept.status, 0);
  EXPECT_NE(kept.said.find("4 finished cases were kept\n"), std::string::npos) << kept.said;
  EXPECT_EQ(marks_of_cases(small.scratch / "out"), before);
  EXPECT_EQ(same_in_every_run(small.scratch / "out"), found);
  const Ending again = small.run("out");
  EXPECT_NE(again.said.find("warning: 4 finished cases are run again; --resume keeps them\n"), std::string::npos);
  EXPECT_EQ(run_again(before, marks_of_cases(small.scratch / "out")).size(), 4U);
}

TEST(LongStudyResume, AnotherSceneIsAnotherCase) {
  const SmallStudy small;
  ASSERT_EQ(small.run("out").status, 0);
  std::string text = small_study_text();
  text.replace(text.find("0.1875"), 6, "0.1250");
  small.scratch.write("study.yaml", text);
  const Ending changed = small.run("out", {"--resume"});
  EXPECT_EQ(changed.status, 0);
  EXPECT_NE(changed.said.find("2 finished cases were kept\n"), std::string::npos) << changed.said;
  EXPECT_EQ(case_folders(small.scratch / "out").size(), 6U);
}

class StudySignals : public testing::TestWithParam<int> {};

/// The signal comes once a case is finished and others are not.
TEST_P(StudySignals, FinishedCasesStay) {
  const SmallStudy small(small_study_text("timing: {repeat: 200, seconds: 20, where: {method: CPDI}}\n"));
  const pid_t child = start_in_group(small, "out", {"--jobs", "1"});
  for (int waited = 0; waited < 3000 && marks_of_cases(small.scratch / "out").size() < 2; ++waited) ::usleep(5000);
  ::kill(GetParam() == SIGINT ? -child : child, GetParam());  // a terminal signals the whole group
  EXPECT_EQ(status_of_child(child), 128 + GetParam());
  EXPECT_TRUE(all_gone(small.scratch / "out", 1)) << "the study did not wait for its case";
  EXPECT_EQ(hidden_in(small.scratch / "out"), std::vector<std::string>{});
  EXPECT_FALSE(fs::exists(small.scratch / "out/study.json"));
  const std::string said = bytes_of(small.scratch / "said");
  EXPECT_EQ(said.find("crashed"), std::string::npos) << said;
  const auto before = marks_of_cases(small.scratch / "out");
  EXPECT_EQ(before.size(), 2U);
  small.scratch.write("study.yaml", small_study_text());
  const Ending resumed = small.run("out", {"--resume"});
  EXPECT_EQ(resumed.status, 0) << resumed.said;
  EXPECT_NE(resumed.said.find("2 finished cases were kept"), std::string::npos) << resumed.said;
  EXPECT_EQ(run_again(before, marks_of_cases(small.scratch / "out")), std::vector<std::string>{});
}

INSTANTIATE_TEST_SUITE_P(Signals, StudySignals, testing::Values(SIGINT, SIGTERM, SIGHUP));

TEST(LongStudyResume, ManyJobsFindTheSameAsOne) {
  const SmallStudy small;
  ASSERT_EQ(small.run("one", {"--jobs", "1"}).status, 0);
  ASSERT_EQ(small.run("four", {"--jobs", "4"}).status, 0);
  EXPECT_EQ(same_in_every_run(small.scratch / "one"), same_in_every_run(small.scratch / "four"));
}

}  // namespace
}  // namespace assay::drivers::test_study_resume
