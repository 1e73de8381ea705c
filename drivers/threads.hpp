// SPDX-License-Identifier: BSD-3-Clause
// How many threads a verb uses.
#pragma once

#include <algorithm>
#include <thread>

namespace assay::drivers {

/// The number asked for; 0: as many as the machine has.
inline int threads_of(int asked) {
  return asked > 0 ? asked : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace assay::drivers
