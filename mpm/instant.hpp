// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace assay::mpm {

/// A step in time.
struct Instant {
  double t = 0;   ///< at the beginning of the step [s]
  double dt = 0;  ///< [s]
};

}  // namespace assay::mpm
