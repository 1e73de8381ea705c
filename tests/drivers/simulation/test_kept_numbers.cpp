// SPDX-License-Identifier: BSD-3-Clause
// Numbers that are kept are the same in a file and in memory, and where a file cannot hold them.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <numeric>

#include "drivers/simulation/kept_numbers.hpp"

namespace assay::drivers::test_kept_numbers {

namespace {

std::vector<double> counted(std::size_t count, double from) {
  std::vector<double> numbers(count);
  std::iota(numbers.begin(), numbers.end(), from);
  return numbers;
}

/// Files of this process may not grow beyond so many bytes.
class SmallFiles {
 public:
  explicit SmallFiles(rlim_t bytes) : signal_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit small{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallFiles() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, signal_);
  }
  SmallFiles(const SmallFiles&) = delete;
  SmallFiles& operator=(const SmallFiles&) = delete;

 private:
  rlimit before_{};
  void (*signal_)(int);
};

TEST(KeptNumbers, AreTheLastOnesThatWerePut) {
  for (const bool in_file : {false, true}) {
    KeptNumbers kept(in_file);
    EXPECT_EQ(kept.in_file(), in_file);
    kept.put(0, counted(1000, 0));
    kept.put(1000, counted(500, 7));
    kept.put(200, counted(10, -3));
    std::vector<double> expected = counted(1000, 0);
    const std::vector<double> more = counted(500, 7);
    expected.insert(expected.end(), more.begin(), more.end());
    std::iota(expected.begin() + 200, expected.begin() + 210, -3);
    EXPECT_EQ(kept.first(1500), expected);
  }
}

TEST(KeptNumbers, GoToMemoryWhereAFileCannotHoldThem) {
  KeptNumbers kept(true);
  const std::vector<double> first = counted(4096, 1), second = counted(4096, 9);
  kept.put(0, first);
  {
    const SmallFiles small(40'000);
    kept.put(first.size(), second);
  }
  EXPECT_FALSE(kept.in_file());
  std::vector<double> expected = first;
  expected.insert(expected.end(), second.begin(), second.end());
  EXPECT_EQ(kept.first(expected.size()), expected);
}

}  // namespace

}  // namespace assay::drivers::test_kept_numbers
