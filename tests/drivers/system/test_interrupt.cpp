// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/system/interrupt.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <csignal>
#include <cstdlib>
#include <fstream>

#include "tests/drivers/process.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::drivers::test_interrupt {
namespace {

// In a child process: handlers and flag must not leak into other tests.
TEST(InterruptDeathTest, first_signal_is_a_flag) {
  EXPECT_EXIT(
      {
        watch_interrupts();
        if (interrupted() || interrupt_signal() != 0) std::_Exit(1);
        std::raise(SIGTERM);
        if (!interrupted() || interrupt_signal() != SIGTERM) std::_Exit(2);
        try {
          stop_if_interrupted();
        } catch (const Interrupted& stop) {
          std::_Exit(128 + stop.signal);
        }
        std::_Exit(3);
      },
      testing::ExitedWithCode(143), "");
}

TEST(Interrupt, ADeadlineStopsLoopsThatPollAndIsOverWithItsScope) {
  constexpr double brief_s = 0.02;
  {
    const Deadline deadline(brief_s);
    EXPECT_THROW(for (;;) stop_if_interrupted(), TimeIsUp);
  }
  EXPECT_NO_THROW(stop_if_interrupted());
  const Deadline long_one(1e6);
  EXPECT_NO_THROW(stop_if_interrupted());
}

TEST(InterruptDeathTest, second_signal_ends_the_process) {
  EXPECT_EXIT(
      {
        watch_interrupts();
        std::raise(SIGINT);
        ::usleep(500'000);
        std::raise(SIGTERM);
        std::_Exit(1);
      },
      testing::ExitedWithCode(128 + SIGTERM), "");
}

// As in a native model that does not come back.
TEST(LongInterruptDeathTest, a_signal_that_nobody_notices_ends_the_process) {
  EXPECT_EXIT(
      {
        watch_interrupts();
        std::raise(SIGINT);
        for (int second = 0; second < 30; ++second) ::usleep(1'000'000);
        std::_Exit(1);
      },
      testing::ExitedWithCode(128 + SIGINT), "");
}

TEST(LongInterruptDeathTest, one_that_is_noticed_leaves_the_time_to_clean_up) {
  EXPECT_EXIT(
      {
        watch_interrupts();
        std::raise(SIGTERM);
        if (!interrupted()) std::_Exit(2);
        for (int second = 0; second < 10; ++second) ::usleep(1'000'000);
        std::_Exit(0);
      },
      testing::ExitedWithCode(0), "");
}

// A thread that only waits sees the signal, and the one that would stop is in a slow model.
TEST(LongInterruptDeathTest, one_that_is_noticed_and_goes_on_ends_too) {
  EXPECT_EXIT(
      {
        watch_interrupts();
        std::raise(SIGTERM);
        for (int second = 0; second < 50; ++second) {
          if (!interrupted()) std::_Exit(2);
          ::usleep(1'000'000);
        }
        std::_Exit(0);
      },
      testing::ExitedWithCode(143), "");
}

// timeout(1) signals its child and then the child's group: folders must still be given back.
TEST(InterruptDeathTest, two_at_once_are_one) {
  EXPECT_EXIT(
      {
        watch_interrupts();
        std::raise(SIGTERM);
        std::raise(SIGTERM);
        std::_Exit(interrupted() ? 3 : 1);
      },
      testing::ExitedWithCode(3), "");
}

TEST(InterruptDeathTest, a_hang_up_is_one_too) {
  EXPECT_EXIT(
      {
        watch_interrupts();
        std::raise(SIGHUP);
        std::_Exit(128 + interrupt_signal());
      },
      testing::ExitedWithCode(129), "");
}

/// Whether the process runs the program and sleeps.
bool sleeps(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  const std::string line{std::istreambuf_iterator<char>(file), {}};
  return line.find("(assay) S ") != line.npos;
}

// A stream into which nobody writes: as the scene, as the points, as the description of the material.
TEST(Interrupt, ends_a_read_that_waits_for_ever) {
  const ScratchFolder scratch;
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  const std::string pipe = "/dev/fd/" + std::to_string(ends[0]);
  const std::string scene = tree_folder() + "/configs/paper/vortex_cpdi.yaml";
  const std::vector<std::vector<std::string>> calls{
      {"run", pipe, "-o", scratch / "out"},
      {"tabulate", pipe, "-o", scratch / "out"},
      {"eval", scene, "--points", pipe},
      {"tabulate", scene, "--points", pipe, "-o", scratch / "out"},
      {"run", scene, "-o", scratch / "out", "--set", "material.adapter=" + pipe}};
  for (const auto& words : calls) {
    const pid_t child = start_assay(words, scratch / "said");
    ASSERT_GT(child, 0);
    constexpr int patience = 60000;  // [ms], for a machine that is busy
    int waited = 0, status = 0;
    for (; !sleeps(child) && waited < patience; ++waited) ::usleep(1000);
    ::kill(child, SIGINT);
    for (; ::waitpid(child, &status, WNOHANG) == 0; ++waited) {
      if (waited >= patience) ::kill(child, SIGKILL);
      ::usleep(1000);
    }
    EXPECT_EQ(WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), 128 + SIGINT) << words[0];
    EXPECT_EQ(bytes_of(scratch / "said"), "") << words[0];
    EXPECT_FALSE(std::filesystem::exists(scratch / "out"));
  }
  ::close(ends[0]), ::close(ends[1]);
}

TEST(InterruptDeathTest, ignored_signals_stay_ignored) {
  EXPECT_EXIT(
      {
        std::signal(SIGINT, SIG_IGN);
        watch_interrupts();
        std::raise(SIGINT);
        std::_Exit(interrupted() ? 1 : 0);
      },
      testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace assay::drivers::test_interrupt
