// SPDX-License-Identifier: BSD-3-Clause
// Loops over fixed blocks of particles, on one thread or several.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <optional>

#include "harness/assay_material.h"
#include "mpm/data/crew.hpp"

namespace assay::mpm {

/// The smallest index that any block of a parallel loop reported; none at first.
class FirstBad {
 public:
  void report(std::size_t index) {
    auto seen = first_.load();
    while (index < seen && !first_.compare_exchange_weak(seen, index)) {
    }
  }
  std::optional<std::size_t> found() const {
    const auto first = first_.load();
    return first == none ? std::nullopt : std::optional(first);
  }

 private:
  static constexpr std::size_t none = ~std::size_t{0};
  std::atomic<std::size_t> first_{none};
};

/// Particles a block: the unit of parallel loops and of the material's batches, fixed so that results do not depend
/// on the number of threads.
inline constexpr std::size_t block_size = 256;
static_assert(block_size <= ASSAY_BATCH_MAX);

/// Particles [begin, end), and where they add to the grid's inertia and force: the grid itself or a copy of it.
struct Block {
  std::size_t begin = 0, end = 0;
  double* inertia = nullptr;
  double* force = nullptr;
};

/// No particle of a block.
inline constexpr std::size_t none_bad = ~std::size_t{0};

inline std::size_t blocks_of(std::size_t particles) { return (particles + block_size - 1) / block_size; }

/// body(begin, end) for all blocks of n particles, on so many threads.
void for_blocks(std::size_t n, int threads, const auto& body) {
  share_out(threads, blocks_of(n), [&](std::size_t b) {
    const std::size_t begin = b * block_size;
    body(begin, std::min(n, begin + block_size));
  });
}

/// A step in time, or a stage of one: a kick, then a drift, which may go back in time.
struct Instant {
  double t = 0;     ///< at the beginning [s]
  double dt = 0;    ///< over which the body moves [s]
  double kick = 0;  ///< over which forces act [s]

  Instant() = default;
  Instant(double begin, double length) : Instant(begin, length, length) {}
  Instant(double begin, double length, double of_forces) : t(begin), dt(length), kick(of_forces) {}
};

}  // namespace assay::mpm
