// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/tool_process.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "drivers/system/input_error.hpp"
#include "drivers/system/interrupt.hpp"
#include "tests/drivers/scratch_folder.hpp"

namespace assay::drivers::test_tool_process {
namespace {

ToolCall shell(const std::string& script) { return {.program = "/bin/sh", .arguments = {"-c", script}}; }

void expect_no_zombie() {
  siginfo_t ended = {};  // others of this process may live
  ::waitid(P_ALL, 0, &ended, WEXITED | WNOHANG | WNOWAIT);
  EXPECT_EQ(ended.si_pid, 0) << "a zombie is left";
}

TEST(ToolProcess, TellsHowItEnded) {
  const ToolEnd good = run_tool(shell("echo one; echo two >&2"));
  EXPECT_EQ(good.status, 0);
  EXPECT_EQ(good.said, "one\ntwo\n");
  EXPECT_EQ(run_tool(shell("exit 5")).status, 5);
  EXPECT_EQ(run_tool(shell("kill -9 $$")).status, 128 + SIGKILL);
  EXPECT_EQ(run_tool({.program = "/absent/tool"}).status, 127);
  expect_no_zombie();
}

TEST(ToolProcess, WorksWhereItIsToldAndInEnglish) {
  const ScratchFolder scratch;
  ToolCall call = shell("pwd; echo $TMPDIR; echo $LC_ALL; cat");
  call.folder = std::filesystem::canonical(scratch / "").string();
  call.temporary = "/tmp/elsewhere";
  EXPECT_EQ(run_tool(call).said, call.folder + "\n/tmp/elsewhere\nC\n");
  call.folder = "/absent";
  EXPECT_EQ(run_tool(call).status, 126);
}

// What a killed program leaves behind comes to an end.
TEST(ToolProcess, HasItsShareOfTheProcessor) {
  ToolCall call = shell("ulimit -t; ulimit -c");
  call.limit_s = 7;
  EXPECT_EQ(run_tool(call).said, "8\n0\n");
}

TEST(ToolProcess, TakesWordsAsTheyStand) {
  const ToolCall call{.program = "/bin/echo", .arguments = {"a b", "$HOME", "'", "*"}};
  EXPECT_EQ(run_tool(call).said, "a b $HOME ' *\n");
}

TEST(ToolProcess, EndsWhatTakesTooLongWithAllThatItHasStarted) {
  const ScratchFolder scratch;
  ToolCall call = shell("(sleep 1; echo late > '" + scratch / "late" + "') & sleep 30");
  call.limit_s = 0.1;
  const ToolEnd end = run_tool(call);
  EXPECT_TRUE(end.stopped);
  std::this_thread::sleep_for(std::chrono::milliseconds(1300));
  EXPECT_FALSE(std::filesystem::exists(scratch / "late"));
  expect_no_zombie();
}

/// As a compiler does, which has the work done by others.
TEST(ToolProcess, EndsWithAProgramThatIsKilledAndSoDoesWhatItHasStarted) {
  const ScratchFolder scratch;
  const std::string begun = scratch / "begun", late = scratch / "late";
  const pid_t program = ::fork();
  if (program == 0) {
    run_tool(shell("(echo > '" + begun + "'; sleep 1; echo late > '" + late + "') & sleep 30"));
    ::_exit(0);
  }
  for (int waited = 0; waited < 500 && !std::filesystem::exists(begun); ++waited)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  ::kill(program, SIGKILL);
  ::waitpid(program, nullptr, 0);
  std::this_thread::sleep_for(std::chrono::milliseconds(1500));
  EXPECT_FALSE(std::filesystem::exists(late));
}

TEST(ToolProcess, IsInterruptedAndLeavesSignalsAsTheyWere) {
  struct sigaction before = {}, after = {};
  sigaction(SIGTERM, nullptr, &before);
  std::thread other([] {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    ::kill(::getpid(), SIGTERM);
  });
  EXPECT_THROW(run_tool(shell("sleep 30")), Interrupted);
  other.join();
  sigaction(SIGTERM, nullptr, &after);
  EXPECT_EQ(after.sa_handler, before.sa_handler);
  expect_no_zombie();
  EXPECT_EQ(run_tool(shell("exit 3")).status, 3) << "an old signal stops nothing";
}

TEST(ToolProcess, IsLookedForInThePath) {
  EXPECT_EQ(tool_in_path("sh").substr(0, 1), "/");
  EXPECT_EQ(tool_in_path("no-such-tool-anywhere"), "");
  EXPECT_EQ(tool_in_path("passwd/.."), "");
}

}  // namespace
}  // namespace assay::drivers::test_tool_process
