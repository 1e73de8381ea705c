// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/process/kept_process.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string>

namespace assay::adapters::test_forked {
namespace {

using End = Forked::End;

TEST(Forked, ReturnsWhatTheFunctionDoes) {
  const std::string much(200000, 'x');  // more than a pipe holds
  EXPECT_EQ(in_a_child([&] { return much; }).text, much);
  const Forked nothing = in_a_child([] { return std::string(); });
  EXPECT_EQ(nothing.end, End::done);
  EXPECT_EQ(nothing.text, "");
}

TEST(Forked, ChangesNothingHere) {
  int value = 1;
  EXPECT_EQ(in_a_child([&] { return std::to_string(++value); }).text, "2");
  EXPECT_EQ(value, 1);
}

TEST(Forked, ReturnsWhatIsThrown) {
  EXPECT_EQ(in_a_child([]() -> std::string { throw std::runtime_error("no"); }).text, "no");
  EXPECT_EQ(in_a_child([]() -> std::string { throw 1; }).text, "throws across the C interface");
}

TEST(Forked, TellsHowItEnded) {
  const Forked killed = in_a_child([] { return std::raise(SIGKILL), std::string("+"); });
  EXPECT_EQ(killed.end, End::signal);
  EXPECT_EQ(killed.signal, SIGKILL);
  for (const int status : {0, 1}) {
    EXPECT_EQ(in_a_child([status]() -> std::string { ::_exit(status); }).end, End::quit);
  }
}

/// All memory that the process shares with its keeper becomes zero, so that the keeper knows no limit any more.
void forget_limits() {
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);) {
    unsigned long begin = 0, end = 0;
    char rights[5] = {};
    if (std::sscanf(line.c_str(), "%lx-%lx %4s", &begin, &end, rights) == 3 && std::string(rights) == "rw-s")
      std::memset(reinterpret_cast<void*>(begin), 0, end - begin);
  }
}

TEST(LongForked, AHangEndsEvenWhereTheModelHasWrittenOverTheLimits) {
  const auto hang = []() -> std::string {
    forget_limits();
    for (;;) ::pause();
  };
  EXPECT_EQ(in_a_child(hang, {.patience_s = 0.2}).end, End::hangs);
}

/// Its pipes must not take their numbers, which the function may close or use.
TEST(Forked, HoldsWhereTheStandardStreamsAreClosed) {
  const pid_t child = ::fork();
  if (child == 0) {
    for (const int stream : {0, 1, 2}) ::close(stream);
    const Forked found = in_a_child([] {
      for (const int stream : {0, 1, 2}) ::close(stream);
      return std::string("said");
    });
    ::_exit(found.end == End::done && found.text == "said" ? 0 : 1);
  }
  int status = 1;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
}

}  // namespace
}  // namespace assay::adapters::test_forked
