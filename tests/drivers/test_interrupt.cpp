// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/interrupt.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>

namespace assay::drivers {
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

TEST(InterruptDeathTest, second_signal_ends_the_process) {
  EXPECT_EXIT(
      {
        watch_interrupts();
        std::raise(SIGINT);
        std::raise(SIGTERM);
        std::_Exit(1);
      },
      testing::ExitedWithCode(128 + SIGTERM), "");
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
}  // namespace assay::drivers
