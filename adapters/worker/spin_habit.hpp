// SPDX-License-Identifier: BSD-3-Clause
// Whether it pays to look for an answer before one sleeps: to wake a sleeping core costs ten times what a short call
// does, but where no core is free, looking keeps the other side from its work.
#pragma once

#include <cstdint>

namespace assay::adapters {

/// Looks as long as most answers come while it does; else sleeps at once, and tries again now and then.
class SpinHabit {
 public:
  static constexpr std::uint32_t microseconds = 30;  ///< of a look
  static constexpr int trials = 4, rest = 256;       ///< calls

  /// How long to look for the answer to the next call [us].
  std::uint32_t look() {
    if (resting_ == 0) return microseconds;
    if (--resting_ == 0) came_ = missed_ = 0;
    return 0;
  }

  /// Whether the answer came in that time; of calls that looked.
  void note(bool came) {
    ++(came ? came_ : missed_);
    if (came_ + missed_ < trials) return;
    if (missed_ > came_) resting_ = rest;
    came_ = missed_ = 0;
  }

 private:
  int came_ = 0, missed_ = 0, resting_ = 0;
};

}  // namespace assay::adapters
