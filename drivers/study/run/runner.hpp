// SPDX-License-Identifier: BSD-3-Clause
// Runs the cases of a study: those that are not timed side by side, then the timed ones alone.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "drivers/study/case_process.hpp"
#include "drivers/study/plan/plan.hpp"
#include "drivers/study/run/case_store.hpp"
#include "drivers/study/run/study_session.hpp"

namespace assay::drivers {

/// Cases are dealt out in turn, so that the expensive resolutions are shared.
struct Shard {
  std::size_t index = 1, count = 1;  ///< this one, from 1, of so many
  bool holds(std::size_t case_number) const { return (case_number - 1) % count == index - 1; }
};

struct RunnerOptions {
  std::string program = "/proc/self/exe";  ///< that runs a case
  int jobs = 1;                            ///< threads of cases that run side by side
  bool resume = false;                     ///< finished cases stay as they are
  const StudySession* session = nullptr;   ///< cases that were finished in it stay, too; null: none
  Shard shard = {};
};

/// What a runner tells on the way.
struct RunnerReport {
  std::size_t done = 0, total = 0;        ///< cases of this call, with those that were kept
  double fraction = 0;                    ///< of the expected work
  const PlannedCase* finished = nullptr;  ///< the case that has just ended
  const PlannedCase* running = nullptr;   ///< a case that runs
  bool waits = false;                     ///< another study runs that case
};

struct RunnerSummary {
  std::size_t run = 0, kept = 0, torn = 0;
};

/// Throws SystemError where results cannot be written: what is finished stays; Interrupted when a signal came.
RunnerSummary run_cases(const Plan& plan, const CaseStore& store, const RunnerOptions& options,
                        const std::function<void(const RunnerReport&)>& tell);

}  // namespace assay::drivers
