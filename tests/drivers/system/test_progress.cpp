// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/system/progress.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <stdlib.h>
#include <unistd.h>

#include <array>
#include <limits>

namespace assay::drivers::test_progress {
namespace {

TEST(Progress, says_durations) {
  EXPECT_EQ(duration_text(0), "0 s");
  EXPECT_EQ(duration_text(2.1), "3 s");
  EXPECT_EQ(duration_text(125), "2 min 05 s");
  EXPECT_EQ(duration_text(4320), "1 h 12 min");
  EXPECT_EQ(duration_text(3 * 86400 + 4 * 3600), "3 d 4 h");
  EXPECT_EQ(duration_text(std::numeric_limits<double>::quiet_NaN()), "?");
  EXPECT_EQ(duration_text(std::numeric_limits<double>::infinity()), "?");
}

TEST(Progress, line_tells_share_and_time_left) {
  EXPECT_EQ(progress_line("run", 0.25, "t = 0.25 s", 10), "run [=====               ] 25 %, 30 s left  t = 0.25 s");
  EXPECT_EQ(progress_line("run", 0, "", 10), "run [                    ] 0 %");
  EXPECT_EQ(progress_line("run", 2, "", 10), "run [====================] 100 %, 0 s left");
  EXPECT_EQ(progress_line("run", std::numeric_limits<double>::quiet_NaN(), "", 1), "run [                    ] 0 %");
}

TEST(Progress, line_fits_the_terminal) {
  const std::string longest(200, 'x');
  EXPECT_LE(progress_line(longest, 0.5, longest, 1e8).size(), 79u);
}

TEST(Progress, is_silent_where_there_is_no_terminal) {
  std::FILE* file = std::tmpfile();
  ASSERT_NE(file, nullptr);
  {
    Progress progress("run", false, file);
    EXPECT_FALSE(progress.active());
    progress.update(0.5);
  }
  EXPECT_EQ(std::ftell(file), 0);
  std::fclose(file);
}

TEST(Progress, rewrites_one_line_and_erases_it_on_a_terminal) {
  const int master = ::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK);
  if (master < 0 || ::grantpt(master) != 0 || ::unlockpt(master) != 0) GTEST_SKIP() << "no pseudo terminal here";
  std::FILE* terminal = std::fopen(::ptsname(master), "w");
  ASSERT_NE(terminal, nullptr);
  {
    Progress quiet("run", true, terminal);
    EXPECT_FALSE(quiet.active());
    Progress progress("run", false, terminal);
    EXPECT_TRUE(progress.active());
    progress.update_at(0.1, 0.1);  // too early: what is over at once shows nothing
    progress.update_at(10, 0.5);
    progress.update_at(10.19, 0.6);  // within a fifth of a second
    progress.update_at(10.21, 0.7);
  }
  const std::string expected =
      "\r\033[Krun [==========          ] 50 %, 10 s left\r\033[Krun [==============      ] 70 %, 5 s left\r\033[K";
  std::string shown;  // a terminal hands on what was written when it comes to it
  while (shown.size() < expected.size()) {
    pollfd ready{master, POLLIN, 0};
    if (::poll(&ready, 1, 10000) <= 0) break;
    std::array<char, 1000> buffer;
    const ssize_t got = ::read(master, buffer.data(), buffer.size());
    if (got <= 0) break;
    shown.append(buffer.data(), static_cast<std::size_t>(got));
  }
  std::fclose(terminal);
  ::close(master);
  EXPECT_EQ(shown, expected);
}

}  // namespace
}  // namespace assay::drivers::test_progress
