// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/data/blocks.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace assay::mpm::test_blocks {
namespace {

TEST(Blocks, CoverEveryParticleOnceWhateverTheThreads) {
  for (const std::size_t n :
       {std::size_t{0}, std::size_t{1}, block_size - 1, block_size, block_size + 1, 7 * block_size + 13}) {
    for (const int threads : {1, 2, 3, 16}) {
      std::vector<int> seen(n, 0);  // blocks are disjoint: no two threads write one element
      for_blocks(n, threads, [&](std::size_t begin, std::size_t end) {
        EXPECT_EQ(begin % block_size, 0u);
        EXPECT_LE(end - begin, block_size);
        for (std::size_t p = begin; p < end; ++p) ++seen[p];
      });
      EXPECT_EQ(seen, std::vector<int>(n, 1)) << n << " on " << threads;
    }
  }
}

TEST(Blocks, TheSmallestReportedIndexWins) {
  FirstBad bad;
  EXPECT_FALSE(bad.found());
  for_blocks(10 * block_size, 2, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      if (p >= 300) bad.report(p);
    }
  });
  EXPECT_EQ(bad.found(), std::optional<std::size_t>(300));
  bad.report(0);
  EXPECT_EQ(bad.found(), std::optional<std::size_t>(0));
}

}  // namespace
}  // namespace assay::mpm::test_blocks
