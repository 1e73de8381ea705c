// SPDX-License-Identifier: BSD-3-Clause
// What a native library does when the process exits, when its model is destroyed, or to end it early.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>

#include "tests/drivers/misdeeds.hpp"
#include "tests/drivers/study/study_program.hpp"
#include "tests/support/some_of.hpp"

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
  if (sanitized() && std::string_view(GetParam()).ends_with("null"))
    GTEST_SKIP() << "the sanitizer reports it in its own words";
  const Misdeeds the;
  const Ending ending = the.program(the.eval_words(the.library), GetParam());
  EXPECT_EQ(ending.status, 0) << ending.said;
  const bool silent = ending.said.empty();  // an end with status 0 looks like any other
  EXPECT_TRUE(silent || ending.said.starts_with("warning: the process ")) << ending.said;
  EXPECT_LE(std::count(ending.said.begin(), ending.said.end(), '\n'), 1) << ending.said;
  EXPECT_NE(bytes_of(the.scratch / "out.csv").find("X,Y,t"), std::string::npos);
  EXPECT_TRUE(the.nothing_is_left());
}

const auto cases_of_at_the_end = one_of_each<AtTheEnd::ParamType>(
    3, testing::Values("exit abort", "exit null", "exit _exit", "exit exit", "exit quick_exit", "exit kill",
                       "exit exec", "exit pause", "destroy abort", "destroy _exit", "destroy null", "destroy deaf"));
const auto name_of_at_the_end = [](const auto& instance) { return name_of(instance.param); };
INSTANTIATE_TEST_SUITE_P(Kinds, AtTheEnd, testing::ValuesIn(cases_of_at_the_end.some), name_of_at_the_end);
INSTANTIATE_TEST_SUITE_P(LongKinds, AtTheEnd, testing::ValuesIn(cases_of_at_the_end.others), name_of_at_the_end);

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
    EXPECT_NE(ending.said.find("\nwarning: the process crashed (signal 6"), std::string::npos) << ending.said;
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
                                         "create exec", "update thread_exit", "update thread_cancel",
                                         "create thread_cancel", "update alarm", "update terminate",
                                         "update interrupt"),
                         [](const auto& instance) { return name_of(instance.param); });

TEST(LongEndOfProcess, ASignalOfTheModelToItsWatcherEndsNoRun) {
  for (const char* deed : {"update terminate_parent", "update hang_up_parent"}) {
    const Misdeeds the;
    const Ending run = the.program(the.run_words(the.library), deed);
    EXPECT_EQ(run.status, 0) << run.said;
    EXPECT_NE(run.said.find("warning: the model sends signal "), std::string::npos) << run.said;
    EXPECT_TRUE(fs::exists(the.scratch / "out/result.json"));
    const Ending check = the.program({"check", the.library, "--quick", "-o", the.scratch / "r"}, deed);
    EXPECT_EQ(check.status, 1) << check.said;
    EXPECT_NE(check.said.find("sends signals to the process that watches it"), std::string::npos) << check.said;
  }
}

/// A terminal that is nobody else's; the program is in front of it.
class Terminal {
 public:
  Terminal() : master_(::posix_openpt(O_RDWR | O_NOCTTY)) {
    ::grantpt(master_);
    ::unlockpt(master_);
    slave_ = ::ptsname(master_);
    held_ = ::open(slave_.c_str(), O_RDWR | O_NOCTTY);  // its settings go with the last who holds it
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;
  ~Terminal() { ::close(held_), ::close(master_); }

  /// In the process that is to have it.
  void take() const {
    ::setsid();
    const int file = ::open(slave_.c_str(), O_RDWR);
    ::ioctl(file, TIOCSCTTY, 0);
  }
  void type(char key) const { ASSERT_EQ(::write(master_, &key, 1), 1); }
  bool echoes() const {
    termios found = {};
    return ::tcgetattr(master_, &found) == 0 && (found.c_lflag & ECHO) != 0;
  }

 private:
  int master_, held_;
  std::string slave_;
};

TEST(EndOfProcess, TheTerminalIsAsItWas) {
  const Misdeeds the;
  const Terminal terminal;
  ASSERT_TRUE(terminal.echoes());
  const Ending run = assay(the.run_words(the.library), [&] {
    terminal.take();
    the.arm("update mute_terminal");
  });
  EXPECT_EQ(run.status, 0) << run.said;
  EXPECT_NE(run.said.find("warning: the model changes the settings of the terminal, which were put right"),
            std::string::npos)
      << run.said;
  EXPECT_TRUE(terminal.echoes());
}

TEST(LongEndOfProcess, CtrlCEndsAModelThatHasLeftItsGroup) {
  constexpr char ctrl_c = 3;
  const Misdeeds the;
  const Terminal terminal;
  const pid_t program = start_assay(the.run_words(the.library), the.scratch / "said", [&] {
    terminal.take();
    the.arm("each leave_group");
  });
  ::usleep(1'000'000);
  terminal.type(ctrl_c);
  int status = 0;
  ::waitpid(program, &status, 0);
  EXPECT_TRUE((WIFEXITED(status) && WEXITSTATUS(status) == 128 + SIGINT) ||
              (WIFSIGNALED(status) && WTERMSIG(status) == SIGINT))
      << status << bytes_of(the.scratch / "said");
}

TEST(LongEndOfProcess, AStudyDoesNotCallARunCrashedThatWasWhole) {
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

TEST(EndOfProcess, AProcessThatStopsItselfIsToldOfAndGoesOn) {
  const Misdeeds the;
  const pid_t child = start_assay(the.run_words(the.library), the.scratch / "said", [&] { the.arm("update stop"); });
  const std::string remedy = "to go on: kill -CONT ";
  std::string said;
  for (int waited = 0; waited < 3000 && said.find(remedy) == said.npos; ++waited, ::usleep(10'000))
    said = bytes_of(the.scratch / "said");
  const std::size_t at = said.find(remedy);
  EXPECT_NE(said.find("is stopped (signal 19"), std::string::npos) << said;
  if (at != said.npos) ::kill(std::stoi(said.substr(at + remedy.size())), SIGCONT);
  if (at == said.npos) ::kill(child, SIGKILL);
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << bytes_of(the.scratch / "said");
  EXPECT_TRUE(fs::exists(the.scratch / "out/result.json"));
}

/// A pipe that is full makes it wait, and cuts nothing off.
TEST(EndOfProcess, OutputThatAModelHurriesIsWhole) {
  const Misdeeds the;
  std::string points = "X,Y,t\n";
  for (int k = 0; k < 2000; ++k) points += "1,0.1,0.3\n";
  the.scratch.write("many.csv", points);
  std::vector<std::string> words = the.eval_words(the.library, "whole.csv");
  words.insert(words.end(), {"--points", the.scratch / "many.csv"});
  words.erase(std::find(words.begin(), words.end(), "--points"), std::find(words.begin(), words.end(), "--points") + 2);
  ASSERT_EQ(the.program(words, "").status, 0);
  *std::find(words.begin(), words.end(), the.scratch / "whole.csv") = "-";
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  const pid_t child = start_assay(words, the.scratch / "said", [&] {
    the.arm("update hurry_output");
    ::dup2(ends[1], STDOUT_FILENO);
    ::close(ends[0]);
  });
  ::close(ends[1]);
  ::usleep(1'000'000);
  std::string read;
  char bytes[4096];
  for (ssize_t n; (n = ::read(ends[0], bytes, sizeof bytes)) > 0;) read.append(bytes, static_cast<std::size_t>(n));
  ::close(ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0) << bytes_of(the.scratch / "said");
  EXPECT_TRUE(read == bytes_of(the.scratch / "whole.csv")) << read.size();
  EXPECT_NE(bytes_of(the.scratch / "said").find("makes the standard streams of the process non-blocking"),
            std::string::npos);
}

TEST(LongEndOfProcess, WhoCalledItCanStopIt) {
  const Misdeeds the;
  const std::vector<std::string> words = the.run_words(the.library);
  for (const int signal : {SIGTERM, SIGXCPU, SIGKILL}) {
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
