// SPDX-License-Identifier: BSD-3-Clause
// What a native library does when the process exits, when its model is destroyed, or to end it early.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/drivers/misdeeds.hpp"
#include "tests/drivers/study/study_program.hpp"

namespace assay::drivers::test_end_of_process {
namespace {

namespace fs = std::filesystem;

class AtTheEnd : public testing::TestWithParam<const char*> {};

std::string name_of(const std::string& deed) {
  std::string name = deed;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
  return name;
}

TEST_P(AtTheEnd, ChangesNoResultAndNoStatus) {
  const Misdeeds the;
  const Ending ending = the.program(the.eval_words(the.library), GetParam());
  EXPECT_EQ(ending.status, 0) << ending.said;
  const bool silent = ending.said.empty();  // an end with status 0 looks like any other
  EXPECT_TRUE(silent || ending.said.starts_with("warning: the process ")) << ending.said;
  EXPECT_LE(std::count(ending.said.begin(), ending.said.end(), '\n'), 1) << ending.said;
  EXPECT_NE(bytes_of(the.scratch / "out.csv").find("X,Y,t"), std::string::npos);
  EXPECT_TRUE(the.nothing_is_left());
}

INSTANTIATE_TEST_SUITE_P(Kinds, AtTheEnd,
                         testing::Values("exit abort", "exit null", "exit _exit", "exit exit", "exit quick_exit",
                                         "exit kill", "exit exec", "exit pause", "destroy abort", "destroy _exit",
                                         "destroy null", "destroy deaf"),
                         [](const auto& instance) { return name_of(instance.param); });

TEST(EndOfProcess, HonestHandlersAreRun) {
  const Misdeeds the;
  const Ending ending = the.program(the.eval_words(the.library), "exit write");
  EXPECT_EQ(ending.status, 0) << ending.said;
  EXPECT_EQ(ending.said, "");
  EXPECT_EQ(bytes_of(the.scratch / "late"), "late");
}

TEST(EndOfProcess, ARunAndATabulationStandToo) {
  const Misdeeds the;
  for (const char* deed : {"exit abort", "destroy abort"}) {
    const Ending ending = the.program(the.run_words(the.library), deed);
    EXPECT_EQ(ending.status, 0) << ending.said;
    EXPECT_NE(ending.said.find("\nwarning: the process died (signal 6"), std::string::npos) << ending.said;
    EXPECT_TRUE(fs::exists(the.scratch / "out/result.json"));
  }
}

class BeforeTheEnd : public testing::TestWithParam<const char*> {};

TEST_P(BeforeTheEnd, IsOneLineAndNoResult) {
  const Misdeeds the;
  const Ending ending = the.program(the.eval_words(the.library), GetParam());
  EXPECT_EQ(ending.status, 3) << ending.said;
  EXPECT_EQ(ending.said.rfind("assay: ", 0), 0u) << ending.said;
  EXPECT_EQ(std::count(ending.said.begin(), ending.said.end(), '\n'), 1) << ending.said;
  EXPECT_FALSE(fs::exists(the.scratch / "out.csv"));
  EXPECT_TRUE(the.nothing_is_left());
}

INSTANTIATE_TEST_SUITE_P(Kinds, BeforeTheEnd,
                         testing::Values("update exec", "update quick_exit", "update kill", "update _exit",
                                         "create exec", "update thread_exit", "update alarm"),
                         [](const auto& instance) { return name_of(instance.param); });

TEST(EndOfProcess, AStudyDoesNotCallARunCrashedThatWasWhole) {
  const Misdeeds the;
  std::string text = small_study_text();
  const std::string axis = "  method: {CPDI: {method.basis: cpdi}, uGIMP: {method.basis: ugimp}}\n";
  text.replace(text.find(axis), axis.size(),
               "  model:\n    bad: {material: {adapter: " + the.library + ", parameters: {}, density: 1000}}\n");
  const std::string file = the.scratch.write("study.yaml", text);
  const Ending ending = the.program({"study", file, "-o", the.scratch / "out"}, "exit abort");
  EXPECT_EQ(ending.status, 0) << ending.said;
  const std::string cases = bytes_of(the.scratch / "out/cases.csv");
  EXPECT_EQ(cases.find("crashed"), std::string::npos) << cases;
  EXPECT_NE(cases.find(",completed,"), std::string::npos) << cases;
}

TEST(EndOfProcess, ALibraryThatIsWrittenOverIsTheCause) {
  const Misdeeds the;
  fs::copy_file(the.library, the.scratch / "late");  // the deed acts on this file
  const Ending early = the.program(the.eval_words(the.scratch / "late"), "update truncate");
  EXPECT_EQ(early.status, 3);
  EXPECT_EQ(early.said, "assay: crashed: the material's library was changed while it was in use\n");
}

TEST(EndOfProcess, DaemonsOfARunAreEndedAndTold) {
  for (const char* deed : {"update daemon", "create far_daemon", "update child"}) {
    const Misdeeds the;
    const Ending ending = the.program(the.run_words(the.library), deed);
    EXPECT_EQ(ending.status, 0) << ending.said;
    EXPECT_NE(ending.said.find("warning: the model leaves processes behind, which were ended\n"), std::string::npos)
        << ending.said;
    EXPECT_NE(bytes_of(the.scratch / "out/result.json").find("\"the model leaves processes behind\""),
              std::string::npos);
    EXPECT_TRUE(the.nothing_is_left()) << deed;
  }
}

TEST(EndOfProcess, ACopyOfTheProcessDoesNotAnswer) {
  const Misdeeds the;
  const Ending honest = the.program(the.run_words(the.library, "honest"), "");
  ASSERT_EQ(honest.status, 0) << honest.said;
  for (const char* deed : {"update fork", "create fork", "destroy fork"}) {
    const Ending ending = the.program(the.run_words(the.library), deed);
    EXPECT_EQ(ending.status, 0) << ending.said;
    EXPECT_EQ(bytes_of(the.scratch / "out/errors.csv"), bytes_of(the.scratch / "honest/errors.csv")) << deed;
    EXPECT_TRUE(the.nothing_is_left()) << deed;
  }
}

TEST(EndOfProcess, WhoCalledItCanStopIt) {
  const Misdeeds the;
  const std::vector<std::string> words = the.run_words(the.library);
  for (const int signal : {SIGTERM, SIGKILL}) {
    const pid_t child = start_assay(words, the.scratch / "said", [&] { the.arm("each nap"); });
    ::usleep(500'000);
    ::kill(child, signal);
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), 128 + signal);
    EXPECT_TRUE(the.nothing_is_left());
  }
  EXPECT_FALSE(fs::exists(the.scratch / "out/result.json"));
}

}  // namespace
}  // namespace assay::drivers::test_end_of_process
