// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/data/crew.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <thread>
#include <vector>

#include "tests/support/built.hpp"

namespace assay::mpm::test_crew {
namespace {

TEST(Crew, TakesEachPieceOnce) {
  for (const int threads : {1, 2, 3, 5}) {
    for (const std::size_t count : {0u, 1u, 2u, 7u, 1000u}) {
      std::vector<std::atomic<int>> taken(count);
      share_out(threads, count, [&](std::size_t i) { ++taken[i]; });
      for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(taken[i], 1) << i << " of " << count << ", " << threads;
    }
  }
}

TEST(Crew, MembersHaveNumbersOfTheirOwn) {
  constexpr int threads = 4;
  std::vector<std::atomic<int>> inside(threads);
  std::atomic<int> wrong{0}, parts{0};
  for (int job = 0; job < 200; ++job) {
    with_crew(threads, [&](int member) {
      if (crew_member() != member || ++inside[static_cast<std::size_t>(member)] != 1) ++wrong;
      ++parts;
      with_crew(threads, [&](int inner) { wrong += inner != member ? 1 : 0; });  // alone
      --inside[static_cast<std::size_t>(member)];
    });
    EXPECT_EQ(crew_member(), 0);
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_GE(parts, 200);  // the calling thread's at least
}

/// So that helpers are there: each of two waits for the other.
TEST(Crew, HelpersTakePart) {
  std::atomic<int> come{0};
  share_out(2, 2, [&](std::size_t) {
    ++come;
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (come < 2 && std::chrono::steady_clock::now() < end) std::this_thread::yield();
  });
  EXPECT_EQ(come, 2);
}

TEST(Crew, WaitsAsleepForWhatComesLate) {
  std::atomic<std::uint32_t> value{0};
  std::thread other([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    value = 1;
    value.notify_all();
  });
  const std::clock_t before = std::clock();
  await(value, 1);
  const double seconds = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
  other.join();
  EXPECT_EQ(value, 1u);
  EXPECT_LT(seconds, 0.01);  // of the processor: half of the time would be 0.01 awake
}

/// Helpers of an earlier test may be starting.
constexpr const char* forked_words =
    "the address sanitizer of LLVM 14 leaves its allocator locked in a child if another thread was in it at the fork";

/// Status of a child that ends within a minute.
template <class Child>
int status_of(const Child& child) {
  std::fflush(stdout);  // once
  const pid_t process = ::fork();
  if (process == 0) {
    ::alarm(60);
    child();
    ::_exit(99);
  }
  int status = 0;
  ::waitpid(process, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

TEST(Crew, AForkedProcessHasOneOfItsOwn) {
  if (sanitized()) GTEST_SKIP() << forked_words;
  const auto sum_of = [] {
    std::atomic<int> sum{0};
    share_out(3, 100, [&](std::size_t i) { sum += static_cast<int>(i); });
    return sum.load();
  };
  EXPECT_EQ(sum_of(), 4950);
  EXPECT_EQ(status_of([&] { ::_exit(sum_of() == 4950 ? 7 : 8); }), 7);
  EXPECT_EQ(status_of([&] { std::exit(9); }), 9);
}

TEST(Crew, AProcessMayEndAmidALoop) {
  if (sanitized()) GTEST_SKIP() << forked_words;
  const auto end_in_part = [](int member) {
    if (member == 0) std::exit(7);
    ::pause();
  };
  EXPECT_EQ(status_of([&] { with_crew(3, end_in_part); }), 7);
}

double seconds_of(const auto& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// As many others as there are cores, each as busy as can be: threads that wait for one another awake took forty times
/// as long there.
TEST(Crew, GivesWayToOtherPrograms) {
  std::atomic<bool> over{false};
  std::vector<std::thread> others;
  for (unsigned k = 0; k < std::max(2u, std::thread::hardware_concurrency()); ++k) {
    others.emplace_back([&] {
      while (!over) {
      }
    });
  }
  std::atomic<double> sink{0};
  const auto loops = [&](int threads) {
    for (int loop = 0; loop < 100; ++loop) {
      share_out(threads, 16, [&](std::size_t i) {
        double x = static_cast<double>(i);
        for (int k = 0; k < 2000; ++k) x = 0.999 * x + 0.001;
        sink = x;
      });
    }
  };
  loops(2);
  double alone = 1e9, together = 1e9;
  for (int k = 0; k < 2; ++k) {
    alone = std::min(alone, seconds_of([&] { loops(1); }));
    together = std::min(together, seconds_of([&] { loops(2); }));
  }
  over = true;
  for (std::thread& other : others) other.join();
  EXPECT_LT(together, 8 * alone);
}

}  // namespace
}  // namespace assay::mpm::test_crew
