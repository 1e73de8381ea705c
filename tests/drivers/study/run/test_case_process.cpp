// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/run/runner.hpp"

#include <gtest/gtest.h>

#include <csignal>

#include "drivers/system/input_error.hpp"
#include "tests/drivers/study/study_program.hpp"

namespace assay::drivers::test_case_process {
namespace {

namespace fs = std::filesystem;

CaseProcess shell(const std::string& script, double limit_s = 0) { return {"/bin/sh", {"-c", script}, limit_s}; }

ProcessEnd end_of(CaseProcess process) {
  while (!process.is_over()) ::usleep(1000);
  return process.end();
}

TEST(CaseProcess, TellsItsStatusAndWhatItSaidLast) {
  const ProcessEnd good = end_of(shell("exit 0"));
  EXPECT_EQ(good.status, 0);
  EXPECT_EQ(good.last_line, "");
  EXPECT_FALSE(good.stopped);
  const ProcessEnd bad = end_of(shell("echo not this; echo first >&2; printf 'the last \\t one\\n\\n' >&2; exit 7"));
  EXPECT_EQ(bad.status, 7);
  EXPECT_EQ(bad.last_line, one_line("the last \t one", 400));
  EXPECT_EQ(end_of(shell("kill -SEGV $$")).status, 128 + SIGSEGV);
}

TEST(CaseProcess, OfMuchThatItSaysTheEndIsKept) {
  const ProcessEnd end =
      end_of(shell("i=0; while [ $i -lt 2000 ]; do echo a line of some length $i; i=$((i+1)); done >&2"));
  EXPECT_EQ(end.last_line, "a line of some length 1999");
  EXPECT_LE(end_of(shell("head -c 100000 /dev/zero | tr '\\0' x >&2")).last_line.size(), 420U);
}

TEST(CaseProcess, HasNoInputAndNothingToPrintOn) {
  const ScratchFolder scratch;
  EXPECT_EQ(end_of(shell("read line; cat; echo a; ls -l /proc/self/fd > '" + (scratch / "open") + "'; exit 5")).status,
            5);
  EXPECT_EQ(bytes_of(scratch / "open").find("assay-case"), bytes_of(scratch / "open").rfind("assay-case"))
      << "standard error alone";
}

TEST(CaseProcess, AProgramThatIsNotThereEndsWithThree) {
  const ProcessEnd end = end_of(CaseProcess("/no/such/program", {"run"}, 0));
  EXPECT_EQ(end.status, 3);
}

TEST(CaseProcess, CountsItsTime) {
  const ProcessEnd busy = end_of(shell("i=0; while [ $i -lt 100000 ]; do i=$((i+1)); done"));
  EXPECT_GT(busy.cpu_s, 0);
  EXPECT_GT(busy.wall_s, 0);
  EXPECT_GE(busy.others, 0);
  const ProcessEnd idle = end_of(shell("sleep 0.1"));
  EXPECT_GE(idle.wall_s, 0.1);
  EXPECT_LT(idle.cpu_s, idle.wall_s);
}

TEST(CaseProcess, IsKilledAtItsLimit) {
  const ProcessEnd end = end_of(shell("trap '' TERM INT; sleep 100 & wait; sleep 100", 0.1));
  EXPECT_TRUE(end.stopped);
  EXPECT_EQ(end.status, 128 + SIGKILL);
  EXPECT_GE(end.wall_s, 0.1);
}

TEST(CaseProcess, GoesWithItsObject) {
  const ScratchFolder scratch;
  const std::string mark = scratch / "asked";
  {
    const CaseProcess asked = shell("trap 'echo yes > " + mark + "; exit' TERM; touch " + mark +
                                    ".up; "
                                    "while :; do sleep 0.01; done");
    for (int waited = 0; waited < 1000 && !fs::exists(mark + ".up"); ++waited) ::usleep(5000);
  }
  EXPECT_EQ(bytes_of(mark), "yes\n") << "asked to end before it is killed";
  EXPECT_TRUE(all_gone(mark, 1));
}

TEST(CaseProcess, MovesWithoutEnding) {
  CaseProcess first = shell("exit 4");
  CaseProcess second(std::move(first));
  EXPECT_TRUE(first.is_over()) << "it has nothing any more";
  EXPECT_EQ(end_of(std::move(second)).status, 4);
}

// A process that is killed cannot end its children: the kernel does.
TEST(CaseProcess, DiesWithItsParent) {
  const ScratchFolder scratch;
  const std::string mark = scratch / "child";
  const pid_t parent = ::fork();
  if (parent == 0) {
    const CaseProcess process = shell("touch " + mark + "; while :; do sleep 0.01; done");
    for (;;) ::pause();
  }
  for (int waited = 0; waited < 1000 && !fs::exists(mark); ++waited) ::usleep(5000);
  ::kill(parent, SIGKILL);
  ::waitpid(parent, nullptr, 0);
  EXPECT_TRUE(all_gone(mark));
}

TEST(Machine, HasANameAndAClock) {
  EXPECT_NE(machine_name().find(" core"), std::string::npos) << machine_name();
  EXPECT_GT(machine_busy_s(), 0);
}

}  // namespace
}  // namespace assay::drivers::test_case_process
