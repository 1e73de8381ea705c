// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace assay::mpm {

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
