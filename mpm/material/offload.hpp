// SPDX-License-Identifier: BSD-3-Clause
// The stress pass in other processes: one hand-over a thread a step, columns that both sides see.
#pragma once

#include <functional>

#include "mpm/material/stress_blocks.hpp"

namespace assay::mpm {

struct Offload {
  /// Memory of n doubles, zero, that the others see; it lives as long as this.
  std::function<double*(std::size_t n)> allocate;
  /// Where the columns lie: once, before the first step.
  std::function<void(const StressColumns<2>& columns)> place;
  /// All blocks of particles [begin, end), which one thread would do. Safe for different threads at once.
  std::function<BlockOutcome(std::size_t thread, std::size_t begin, std::size_t end, const Instant& now)> update;
};

}  // namespace assay::mpm
