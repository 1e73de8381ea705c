// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/system/exit_guard.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <cstdlib>

#include "tests/drivers/process.hpp"
#include "tests/drivers/registry_fixture.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_exit_guard {
namespace {

const std::string scene = tree_folder() + "/configs/paper/vortex_cpdi.yaml";
constexpr const char* ended = "assay: the process was ended from inside, most likely by the material's library\n";

/// A short run, a tabulation and an evaluation with a test plug-in; their results go to `out`.
std::vector<std::vector<std::string>> calls(const ScratchFolder& scratch, const std::string& plugin) {
  const std::vector<std::string> model{"--set", "material.adapter=" + plugins + plugin, "--set",
                                       "material.parameters={}"};
  const std::string points = scratch.write("points.csv", "X,Y,t\n1,0.1,0.3\n");
  std::vector<std::vector<std::string>> all{{"run", scene, "-o", scratch / "out/run", "--set", "grid.spacing=0.125",
                                             "--set", "time.end=0.1", "--set", "output.particles=0"},
                                            {"tabulate", scene, "-o", scratch / "out/tabulate"},
                                            {"eval", scene, "--points", points, "-o", scratch / "out.csv"}};
  for (auto& words : all) words.insert(words.end(), model.begin(), model.end());
  return all;
}

/// Nothing that looks like a result lies there.
void expect_no_result(const ScratchFolder& scratch) {
  for (const char* name : {"out/run/result.json", "out/tabulate/result.json", "out.csv"}) {
    EXPECT_FALSE(std::filesystem::exists(scratch / name)) << name;
  }
}

TEST(ExitGuard, AModelThatEndsTheProcessIsNoSuccess) {
  const ScratchFolder scratch;
  for (const auto& words : calls(scratch, "exits.so")) {
    const Ending ending = assay(words);
    EXPECT_EQ(ending.status, 3) << words[0];
    EXPECT_EQ(ending.said, ended) << words[0];
  }
  expect_no_result(scratch);
}

TEST(ExitGuard, AModelThatCrashesIsOneLine) {
  const ScratchFolder scratch;
  for (const auto& words : calls(scratch, "crashes.so")) {
    const Ending ending = assay(words);
    EXPECT_EQ(ending.status, 3) << words[0];
    EXPECT_EQ(ending.said, "assay: crashed (signal 6), most likely in the material's library\n") << words[0];
  }
  expect_no_result(scratch);
}

/// Of a run with a built-in model, which takes longer than this test lets it live.
TEST(LongExitGuard, ASignalFromOutsideIsNoCrashOfAModel) {
  const ScratchFolder scratch;
  const std::vector<std::string> words{"run", scene, "-o", scratch / "out", "--set", "grid.spacing=0.02", "--quiet"};
  for (const int signal : {SIGABRT, SIGSEGV, SIGFPE, SIGXCPU}) {
    if (sanitized() && signal != SIGXCPU) continue;  // which has handlers of its own
    const pid_t child = start_assay(words, scratch / "said");
    ::usleep(500'000);
    ::kill(child, signal);
    int status = 0;
    ::waitpid(child, &status, 0);
    const std::string said = bytes_of(scratch / "said");
    const bool stops = signal == SIGXCPU;
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == (stops ? 128 + SIGXCPU : 3)) << signal << ": " << said;
    EXPECT_EQ(said, stops ? ""
                          : "assay: ended from outside, by signal " + std::to_string(signal) + " of process " +
                                std::to_string(::getpid()) + "\n");
    EXPECT_FALSE(std::filesystem::exists(scratch / "out/result.json"));
  }
}

TEST(ExitGuard, AnInterruptedVerbLeavesNothing) {
  const ScratchFolder scratch;
  for (const auto& words : calls(scratch, "interrupts.so")) {
    const Ending ending = assay(words);
    EXPECT_EQ(ending.status, 129) << words[0];
    EXPECT_EQ(ending.said, "") << words[0];
  }
  EXPECT_FALSE(std::filesystem::exists(scratch / "out"));
  for (const auto& entry : std::filesystem::directory_iterator(scratch / "")) {
    EXPECT_EQ(entry.path().filename(), "points.csv");
  }
}

TEST(ExitGuard, TheProbesOwnProcessIsNotGuarded) {
  const ScratchFolder scratch;
  for (const char* plugin : {"exits.so", "crashes.so"}) {
    const Ending ending =
        assay({"register", plugins + plugin}, [&] { ::setenv("ASSAY_DATA_HOME", (scratch / "data").c_str(), 1); });
    EXPECT_EQ(ending.status, 2);
    EXPECT_EQ(std::count(ending.said.begin(), ending.said.end(), '\n'), 1) << ending.said;
    EXPECT_NE(ending.said.find("is refused"), std::string::npos) << ending.said;
  }
}

TEST(ExitGuard, AFileThatGrowsTooLargeIsAnOrdinaryError) {
  const ScratchFolder scratch;
  auto words = calls(scratch, "frozen_1_0.so")[1];
  const Ending ending = assay(words, [] {
    const rlimit limit{4096, 4096};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  });
  EXPECT_EQ(ending.status, 3) << ending.said;
  EXPECT_NE(ending.said.find("cannot be written: File too large"), std::string::npos) << ending.said;
  EXPECT_FALSE(std::filesystem::exists(scratch / "out"));
}

TEST(ExitGuardDeathTest, ExitIsCaughtWhileOneLivesAndNotAfter) {
  EXPECT_EXIT(
      {
        const ExitGuard guard;
        std::exit(0);
      },
      testing::ExitedWithCode(3), "ended from inside");
  EXPECT_EXIT(
      {
        { const ExitGuard guard; }
        std::exit(0);
      },
      testing::ExitedWithCode(0), "^$");
}

TEST(ExitGuardDeathTest, HandlersThatWereThereStay) {
  EXPECT_EXIT(
      {
        std::signal(SIGFPE, [](int) { std::_Exit(17); });
        const ExitGuard guard;
        std::raise(SIGFPE);
      },
      testing::ExitedWithCode(17), "^$");
  EXPECT_EXIT(
      {
        std::signal(SIGSEGV, SIG_DFL);  // a sanitizer's
        const ExitGuard guard;
        std::raise(SIGSEGV);
      },
      testing::ExitedWithCode(3), "crashed \\(signal 11\\)");
  EXPECT_EXIT(
      {
        std::signal(SIGILL, SIG_DFL);
        const ExitGuard guard;
        std::raise(SIGILL);
      },
      testing::ExitedWithCode(3), "crashed \\(signal 4\\)");
}

}  // namespace
}  // namespace assay::drivers::test_exit_guard
