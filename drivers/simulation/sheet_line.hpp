// SPDX-License-Identifier: BSD-3-Clause
// What a terminal shows while a sheet is made, and what is said before a long one.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "drivers/system/progress.hpp"
#include "harness/sheet/sheet.hpp"

namespace assay::drivers {

/// Of a sheet that is expected to take so long, at that tolerance: what makes it shorter.
std::string long_sheet_sentence(double seconds, double tolerance);

/// How long work may take in all [s], where that is to be told now: at first where it is long, again where it takes
/// longer than was told. elapsed_s, share: of the work until now.
class Forecast {
 public:
  std::optional<double> told(double elapsed_s, double share);
  bool was_told() const { return told_s_ > 0; }

 private:
  double told_s_ = 0;
};

class SheetLine {
 public:
  SheetLine(double tolerance, bool quiet);
  SheetLine(const SheetLine&) = delete;
  SheetLine& operator=(const SheetLine&) = delete;

  void update(const SheetProgress& now);

  /// Behind the last update: whoever was told of a long time is told of its end.
  void end();

 private:
  using Clock = std::chrono::steady_clock;
  void foresee(const SheetProgress& now);
  double elapsed_s() const;

  double tolerance_;
  bool quiet_;
  Forecast forecast_;
  Progress progress_;
  Clock::time_point begin_ = {};  ///< of the histories
  double behind_ = -1;            ///< histories that were followed then; below 0: none is yet
};

}  // namespace assay::drivers
