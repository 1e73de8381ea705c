// SPDX-License-Identifier: BSD-3-Clause
#include "harness/numeric/parallel.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace assay::test_parallel {
namespace {

TEST(Parallel, DoesEveryPieceOnce) {
  for (const int threads : {1, 2, 7}) {
    std::vector<int> done(100, 0);
    for_each_index(100, {threads, {}}, [&](int i) { ++done[static_cast<std::size_t>(i)]; });
    EXPECT_EQ(done, std::vector<int>(100, 1)) << threads;
    for_each_index(0, {threads, {}}, [](int) { FAIL(); });
  }
}

TEST(Parallel, PassesOnTheFailureOfTheSmallestIndex) {
  for (const int threads : {1, 4}) {
    for (int repeat = 0; repeat < 20; ++repeat) {
      try {
        for_each_index(64, {threads, {}}, [](int i) {
          if (i % 10 == 7) throw std::runtime_error(std::to_string(i));
        });
        FAIL();
      } catch (const std::runtime_error& error) {
        EXPECT_STREQ(error.what(), "7");
      }
    }
  }
}

TEST(Parallel, PollsAndStops) {
  int polls = 0, pieces = 0;
  const Workers workers{1, [&] {
                          if (++polls == 5) throw std::runtime_error("stop");
                        }};
  EXPECT_THROW(for_each_index(100, workers, [&](int) { ++pieces; }), std::runtime_error);
  EXPECT_EQ(pieces, 4);
}

}  // namespace
}  // namespace assay::test_parallel
