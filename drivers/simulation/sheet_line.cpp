// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/sheet_line.hpp"

#include <cstdio>

#include "drivers/output/number_format.hpp"

namespace assay::drivers {

std::string long_sheet_sentence(double seconds, double tolerance) {
  constexpr double usual = 1e-10, coarser = 1e3;
  const double other = std::max(tolerance, usual) * coarser;
  return "to tabulate this material's response may take up to " + duration_text(seconds) +
         ", often a third of it or less; shorter with force.tolerance: " + rounded_text(other, 2) + " in place of " +
         rounded_text(tolerance, 2) + ", or with a smaller time.end";
}

SheetLine::SheetLine(double tolerance, bool quiet) : tolerance_(tolerance), quiet_(quiet), progress_("sheet", quiet) {}

void SheetLine::update(const SheetProgress& now) {
  using Stage = SheetProgress::Stage;
  foresee(now);
  const double share = now.planned > 0 ? now.done / now.planned : 0;
  progress_.update(share, now.stage == Stage::bands       ? "looking for kinks"
                          : now.stage == Stage::histories ? "following histories"
                                                          : "measuring its error");
}

void SheetLine::foresee(const SheetProgress& now) {
  constexpr double enough_s = 5, long_s = 30;
  if (quiet_ || foreseen_ || now.stage != SheetProgress::Stage::histories) return;
  if (behind_ < 0) begin_ = Clock::now(), behind_ = now.done;
  const double elapsed_s = std::chrono::duration<double>(Clock::now() - begin_).count(), done = now.done - behind_;
  if (elapsed_s < enough_s || !(done > 0)) return;
  const double expected_s = elapsed_s * (now.planned - behind_) / done;
  if (expected_s < long_s) return;
  foreseen_ = true;
  progress_.finish();
  std::fprintf(stderr, "%s\n", long_sheet_sentence(expected_s, tolerance_).c_str());
}

}  // namespace assay::drivers
