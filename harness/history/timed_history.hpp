// SPDX-License-Identifier: BSD-3-Clause
// One history as a function of time: what it is at t does not depend on the times that were asked before, to the last
// bit. Steps with error control end where they are told to, so that a history which stops at other times differs from
// it by rounding and by its tolerance. This one stops at the ends of panels of one length, and at t.
#pragma once

#include <memory>
#include <vector>

#include "harness/history/history.hpp"

namespace assay {

class TimedHistory {
 public:
  /// Keeps the course. panel: [s]; keeps_all: a state for each panel is kept, so that going back in time is as quick as
  /// going on; else it begins anew.
  TimedHistory(const Course& course, double xi, const HistoryOptions& options, double panel, bool keeps_all);

  /// First Piola-Kirchhoff stress [Pa]. Throws MaterialFailure.
  Tensor tau(double t);

  double error() const { return error_; }  ///< largest that was estimated, relative
  std::int64_t calls() const { return calls_; }

 private:
  void begin();
  void note(const History& history, std::int64_t calls_before);

  const Course* course_;
  double xi_;
  HistoryOptions options_;
  double panel_;
  bool keeps_all_;
  std::size_t first_ = 0;                         ///< panel of the first that is kept
  std::vector<std::unique_ptr<History>> begins_;  ///< at the beginnings of panels first_, first_ + 1, ...
  double error_ = 0;
  std::int64_t calls_ = 0;
};

}  // namespace assay
