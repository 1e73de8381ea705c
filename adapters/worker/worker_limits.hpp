// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace assay::adapters {

/// What a worker may take.
struct WorkerLimits {
  double seconds = 20;   ///< of one call
  double gigabytes = 4;  ///< of memory, beyond what it begins with
};

}  // namespace assay::adapters
