// SPDX-License-Identifier: BSD-3-Clause
// What a terminal shows while a sheet is made, and what is said before a long one.
#pragma once

#include <chrono>
#include <string>

#include "drivers/progress.hpp"
#include "harness/sheet/sheet.hpp"

namespace assay::drivers {

/// Of a sheet that is expected to take so long, at that tolerance: what makes it shorter.
std::string long_sheet_sentence(double seconds, double tolerance);

class SheetLine {
 public:
  SheetLine(double tolerance, bool quiet);
  SheetLine(const SheetLine&) = delete;
  SheetLine& operator=(const SheetLine&) = delete;

  void update(const SheetProgress& now);

 private:
  using Clock = std::chrono::steady_clock;
  void foresee(const SheetProgress& now);

  double tolerance_;
  bool quiet_, foreseen_ = false;
  Progress progress_;
  Clock::time_point begin_ = {};  ///< of the histories
  double behind_ = -1;            ///< histories that were followed then; below 0: none is yet
};

}  // namespace assay::drivers
