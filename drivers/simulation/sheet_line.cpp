// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/simulation/sheet_line.hpp"

#include <algorithm>
#include <cstdio>

#include "drivers/text/number_format.hpp"

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
  if (quiet_ || now.stage != SheetProgress::Stage::histories) return;
  if (behind_ < 0) begin_ = Clock::now(), behind_ = now.done;
  const double planned = now.planned - behind_;
  const auto seconds = forecast_.told(elapsed_s(), planned > 0 ? (now.done - behind_) / planned : 0);
  if (!seconds) return;
  progress_.finish();
  std::fprintf(stderr, "%s\n", long_sheet_sentence(*seconds, tolerance_).c_str());
}

double SheetLine::elapsed_s() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }

void SheetLine::end() {
  progress_.finish();
  if (forecast_.was_told())
    std::fprintf(stderr, "the response is tabulated, in %s\n", duration_text(elapsed_s()).c_str());
}

std::optional<double> Forecast::told(double elapsed_s, double share) {
  constexpr double enough_s = 5, long_s = 30, least_more = 1.5;
  if (elapsed_s < std::max(enough_s, told_s_) || !(share > 0)) return std::nullopt;
  const double expected_s = elapsed_s / share;
  if (expected_s < long_s) return std::nullopt;
  told_s_ = std::max(expected_s, least_more * elapsed_s);
  return told_s_;
}

}  // namespace assay::drivers
