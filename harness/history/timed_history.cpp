// SPDX-License-Identifier: BSD-3-Clause
#include "harness/history/timed_history.hpp"

#include <algorithm>
#include <cmath>

namespace assay {

TimedHistory::TimedHistory(const Course& course, double xi, const HistoryOptions& options, double panel, bool keeps_all)
    : course_(&course), xi_(xi), options_(options), panel_(panel), keeps_all_(keeps_all) {
  begin();
}

void TimedHistory::begin() {
  begins_.clear();
  first_ = 0;
  begins_.push_back(std::make_unique<History>(*course_, xi_, options_));
}

void TimedHistory::note(const History& history, std::int64_t calls_before) {
  error_ = std::max(error_, history.error());
  calls_ += history.calls() - calls_before;
}

Tensor TimedHistory::tau(double t) {
  const auto panel = static_cast<std::size_t>(std::max(0.0, std::floor(t / panel_)));
  if (panel < first_) begin();
  while (first_ + begins_.size() <= panel) {
    auto next = begins_.back()->copy();
    const std::int64_t before = next->calls();
    next->advance(static_cast<double>(first_ + begins_.size()) * panel_);
    note(*next, before);
    if (!keeps_all_) begins_.clear(), ++first_;
    begins_.push_back(std::move(next));
  }
  const auto now = begins_[panel - first_]->copy();
  const std::int64_t before = now->calls();
  now->advance(t);
  note(*now, before);
  return now->tau();
}

}  // namespace assay
