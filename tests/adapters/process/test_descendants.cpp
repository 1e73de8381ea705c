// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/process/descendants.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

namespace assay::adapters::test_descendants {
namespace {

void sleep_for_long() {
  for (unsigned left = 1000; left > 0;) left = ::sleep(left);
}

/// Starts a process that leaves its parent, and its group.
void leave_daemon() {
  const pid_t first = ::fork();
  if (first != 0) {
    ::waitpid(first, nullptr, 0);
    return;
  }
  ::setsid();
  if (::fork() == 0) sleep_for_long();
  ::_exit(0);
}

/// What a process of its own says by its status.
template <class Work>
int status_of(const Work& work) {
  const pid_t process = ::fork();
  if (process == 0) ::_exit(work());
  int status = -1;
  ::waitpid(process, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(Descendants, AreEndedWhereverTheyHaveGone) {
  EXPECT_EQ(status_of([] {
              adopt_orphans();
              leave_daemon();
              if (::fork() == 0) sleep_for_long();
              const bool first = end_descendants(), second = end_descendants();
              const bool none = ::waitpid(-1, nullptr, WNOHANG) == -1;
              return first && !second && none ? 7 : 1;
            }),
            7);
}

TEST(Descendants, NoneAreNoneToEnd) {
  EXPECT_EQ(status_of([] { return end_descendants() ? 1 : 7; }), 7);
}

TEST(Descendants, AChildKnowsWhetherItsParentAdopts) {
  EXPECT_FALSE(parent_adopts());
  EXPECT_EQ(status_of([] {
              adopt_orphans();
              return status_of([] { return parent_adopts() ? 7 : 1; });
            }),
            7);
}

}  // namespace
}  // namespace assay::adapters::test_descendants
