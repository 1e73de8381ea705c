// SPDX-License-Identifier: BSD-3-Clause
// Which point of a batch is being worked on: for whoever looks on from outside when the process dies.
#pragma once

#include <atomic>
#include <cstddef>

namespace assay::adapters {

/// Where to; null where nobody looks on.
inline std::atomic<std::atomic<std::size_t>*> point_mark{nullptr};

inline void mark_point(std::size_t point) {
  if (auto* mark = point_mark.load(std::memory_order_relaxed)) mark->store(point, std::memory_order_relaxed);
}

}  // namespace assay::adapters
