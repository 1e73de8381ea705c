// SPDX-License-Identifier: BSD-3-Clause
// What a study meets while its cases run: a full disk, no right to write, time limits, models that crash.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include "tests/drivers/study/study_program.hpp"
#include "tests/support/built.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_study_failures {
namespace {

namespace fs = std::filesystem;

/// No file may be longer than this: as on a full disk every write beyond it fails.
std::function<void()> files_up_to(rlim_t bytes) {
  return [bytes] {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{bytes, bytes};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  };
}

/// One line that names a file of the folder and why it could not be written.
void expect_one_line(const Ending& ending, const std::string& folder) {
  EXPECT_EQ(ending.status, 3) << ending.said;
  EXPECT_EQ(ending.said.rfind(folder, 0), 0U) << ending.said;
  EXPECT_EQ(std::count(ending.said.begin(), ending.said.end(), '\n'), 1) << ending.said;
}

TEST(LongStudyFailures, AFullDiskIsOneLineAndResumes) {
  const SmallStudy small;
  ASSERT_EQ(small.run("whole").status, 0);
  std::size_t finished = 0;
  for (const rlim_t bytes : {300, 2000, 20000}) {  // no scene, no result, no report fits
    const Ending full = small.run("out", {"--resume", "--quiet"}, files_up_to(bytes));
    expect_one_line(full, small.scratch / "out");
    EXPECT_NE(full.said.find("File too large"), std::string::npos) << full.said;
    EXPECT_FALSE(fs::exists(small.scratch / "out/study.json"));
    EXPECT_EQ(hidden_in(small.scratch / "out"), std::vector<std::string>{});
    const std::size_t now = marks_of_cases(small.scratch / "out").size();
    EXPECT_EQ(now, bytes < 20000 ? 0U : 4U) << bytes << " bytes";
    finished = now;
  }
  const auto before = marks_of_cases(small.scratch / "out");
  const Ending resumed = small.run("out", {"--resume"});
  EXPECT_EQ(resumed.status, 0) << resumed.said;
  EXPECT_NE(resumed.said.find(std::to_string(finished) + " finished cases were kept"), std::string::npos);
  EXPECT_EQ(marks_of_cases(small.scratch / "out"), before);
  EXPECT_EQ(same_in_every_run(small.scratch / "out"), same_in_every_run(small.scratch / "whole"));
}

TEST(StudyFailures, AFolderThatCannotBeMadeIsOneLine) {
  const SmallStudy small;
  small.scratch.write("file", "not a folder");
  expect_one_line(small.run("file/out", {"--quiet"}), small.scratch / "file/out");
  expect_one_line(small.run("file/out", {"--shard", "1/2"}), small.scratch / "file/out");
}

TEST(StudyFailures, AFolderWithoutTheRightToWriteIsOneLine) {
  const SmallStudy small;
  fs::create_directories(small.scratch / "out");
  fs::permissions(small.scratch / "out", fs::perms::owner_read | fs::perms::owner_exec | fs::perms::others_exec);
  const Ending ending = small.run("out", {"--quiet"}, [] {  // root may write anywhere
    if (::getuid() == 0 && (::setgid(65534) != 0 || ::setuid(65534) != 0)) ::_exit(126);
  });
  fs::permissions(small.scratch / "out", fs::perms::owner_all);
  if (ending.status >= 126) GTEST_SKIP() << "the program cannot be started as another user";
  expect_one_line(ending, small.scratch / "out");
}

// The finer grid takes ten seconds and more, of which it is given two.
TEST(LongStudyFailures, ALimitStopsACase) {
  std::string text = small_study_text("timing: none\nlimit: 2\n");
  text.replace(text.find("0.1875"), 6, "0.0125");
  text.replace(text.find("time.end: 0.05"), 14, "time.end: 1");
  text.replace(text.find(", uGIMP: {method.basis: ugimp}"), 30, "");
  const SmallStudy small(text);
  const Ending stopped = small.run("out", {"--json"});
  EXPECT_NE(stopped.said.find("\"stopped\""), std::string::npos) << stopped.said.substr(0, 1000);
  EXPECT_TRUE(all_gone(small.scratch / "out", 1));
  const std::string cases = bytes_of(small.scratch / "out/cases.csv");
  EXPECT_NE(cases.find(",stopped,it took longer than the limit of the study,"), std::string::npos) << cases;
  EXPECT_NE(cases.find(",completed,"), std::string::npos) << cases;
  const auto before = marks_of_cases(small.scratch / "out");
  const Ending resumed = small.run("out", {"--resume"});
  EXPECT_NE(resumed.said.find("2 finished cases were kept"), std::string::npos) << "another attempt would take as long";
  EXPECT_EQ(marks_of_cases(small.scratch / "out"), before);
  const std::string longer = std::string(text).replace(text.find("limit: 2"), 8, "limit: 2.1");
  small.scratch.write("study.yaml", longer);
  EXPECT_NE(small.run("out", {"--resume"}).said.find("1 finished cases were kept"), std::string::npos)
      << "the other has more time now";
}

/// One case's model aborts, the other's does not.
std::string crashing_study_text(const std::string& plugin = "crashes_in_a_run.so") {
  std::string text = small_study_text();
  const std::string axis = "  method: {CPDI: {method.basis: cpdi}, uGIMP: {method.basis: ugimp}}\n";
  text.replace(text.find(axis), axis.size(),
               "  model:\n    good: {material.adapter: neo_hookean}\n"
               "    bad: {material: {adapter: " +
                   built("tests/plugins/") + plugin +
                   ", parameters: {}, "
                   "density: 1000}}\n");
  return text;
}

TEST(StudyFailures, AModelThatCrashesCostsItsOwnCasesAndIsTriedAgain) {
  const SmallStudy small(crashing_study_text());
  const Ending first = small.run("out");
  EXPECT_EQ(first.status, 1) << first.said;
  EXPECT_NE(bytes_of(small.scratch / "out/study.junit.xml").find("failures=\"2\""), std::string::npos);
  const std::string cases = bytes_of(small.scratch / "out/cases.csv");
  EXPECT_NE(cases.find(",crashed,"), std::string::npos) << cases;
  EXPECT_NE(cases.find("crashed (signal 6)"), std::string::npos) << cases;
  EXPECT_NE(cases.find(",completed,"), std::string::npos) << cases;
  const auto before = marks_of_cases(small.scratch / "out");
  const Ending resumed = small.run("out", {"--resume"});
  EXPECT_NE(resumed.said.find("2 finished cases were kept"), std::string::npos) << resumed.said;
  std::size_t again = 0;
  for (const auto& [folder, mark] : marks_of_cases(small.scratch / "out")) again += before.at(folder) == mark ? 0 : 1;
  EXPECT_EQ(again, 2U);
  EXPECT_EQ(bytes_of(small.scratch / "out/cases.csv"), cases);
}

// Scenes are read in the study's own process, which asks the model for its stiffness.
TEST(StudyFailures, AModelThatCrashesAtRestIsOneLineBeforeAnythingIsRun) {
  const SmallStudy small(crashing_study_text("crashes.so"));
  const Ending ending = small.run("out");
  EXPECT_EQ(ending.status, 3);
  EXPECT_EQ(ending.said, "assay: crashed (signal 6), most likely in the material's library\n");
  EXPECT_FALSE(fs::exists(small.scratch / "out"));
}

TEST(LongStudyFailures, ACrashElsewhereComesWithAMerge) {
  const SmallStudy small(crashing_study_text());
  ASSERT_EQ(small.run("whole").status, 1);
  for (const char* shard : {"1/2", "2/2"})
    ASSERT_EQ(small.run(std::string("part") + shard[0], {"--shard", shard}).status, 0);
  const Ending merged =
      small.run("out", {"--merge", "--from", small.scratch / "part1", "--from", small.scratch / "part2"});
  EXPECT_EQ(merged.status, 1) << merged.said;
  EXPECT_EQ(same_in_every_run(small.scratch / "out"), same_in_every_run(small.scratch / "whole"));
}

/// Not after hours of work, and without a trace.
TEST(StudyFolder, OfARunIsRefusedBeforeACaseIsRun) {
  const std::string study = tree_folder() + "/configs/studies/quick.yaml";
  for (const std::vector<std::string>& more : {std::vector<std::string>{}, {"--shard", "1/2"}, {"--merge"}}) {
    const ScratchFolder scratch;
    const std::string file = scratch.write("result.json", "{}");
    std::vector<std::string> words{"study", study, "-o", scratch / ""};
    words.insert(words.end(), more.begin(), more.end());
    const Ending ending = assay(words);
    EXPECT_EQ(ending.status, 2) << ending.said;
    EXPECT_NE(ending.said.find("holds the results of a run (result.json)"), std::string::npos) << ending.said;
    const std::filesystem::directory_iterator entries(scratch / ""), end;
    EXPECT_EQ(std::distance(entries, end), 1) << "result.json alone";
  }
}

}  // namespace
}  // namespace assay::drivers::test_study_failures
