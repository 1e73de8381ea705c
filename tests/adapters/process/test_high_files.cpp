// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/process/private_files.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace assay::adapters::test_high_files {
namespace {

/// The status of a process that does it, 0 where it is true.
template <class Statement>
int elsewhere(const Statement& statement) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(statement() ? 0 : 1);
  int status = 1;
  ::waitpid(child, &status, 0);
  return status;
}

bool allow_files(rlim_t count) {
  const rlimit limit{count, count};
  return ::setrlimit(RLIMIT_NOFILE, &limit) == 0;
}

TEST(HighFiles, ArePipes) {
  int ends[2] = {-1, -1};
  ASSERT_TRUE(high_pipe(ends));
  for (const int end : ends) {
    EXPECT_GE(end, 16);
    EXPECT_NE(::fcntl(end, F_GETFD) & FD_CLOEXEC, 0) << "no other program inherits it";
  }
  char heard = 0;
  EXPECT_EQ(::write(ends[1], "+", 1), 1);
  EXPECT_EQ(::read(ends[0], &heard, 1), 1);
  EXPECT_EQ(heard, '+');
  for (const int end : ends) ::close(end);
}

TEST(HighFiles, StandAboveOursWhereFewAreAllowed) {
  EXPECT_EQ(elsewhere([] {
              int ends[2] = {-1, -1};
              return allow_files(40) && high_pipe(ends) && ends[0] >= 16 && ends[1] >= 16;
            }),
            0);
}

TEST(HighFiles, LeaveNoneBehindWhereTheyCannotBeHad) {
  EXPECT_EQ(elsewhere([] {
              int ends[2] = {-1, -1};
              if (!allow_files(17) || high_pipe(ends)) return false;
              const bool said = errno == EMFILE;
              return said && ::dup(STDERR_FILENO) >= 0;
            }),
            0);
}

}  // namespace
}  // namespace assay::adapters::test_high_files
