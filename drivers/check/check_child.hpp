// SPDX-License-Identifier: BSD-3-Clause
// The process in which one material is checked, as its parent knows it.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "adapters/process/kept_process.hpp"
#include "drivers/check/check_process.hpp"
#include "harness/material/progress_mark.hpp"

namespace assay::drivers {

/// How what a process prints begins that had no memory for a report.
inline constexpr const char* no_memory_words = "no memory is left";

class CheckChild {
 public:
  /// Throws SystemError where no process can be made.
  CheckChild(const std::vector<CheckTask>& tasks, std::size_t task, double limit_s);

  std::size_t task() const { return task_; }
  int records() const { return records_.in(); }
  const std::string& said() const { return said_; }  ///< its records so far
  const adapters::Fate& fate() const { return process_->fate(); }
  CallPhase phase() const { return static_cast<CallPhase>(fate().phase.load()); }  ///< in which its end came

  /// Reads what there is, and ends what takes longer than its limit. True: nothing can come any more, since the process
  /// has ended, whoever else may hold its pipe, or the pipe is closed.
  bool look();
  /// Once that is so: waits a little for the end of the process.
  void await_end();

  bool is_late() const { return late_; }
  /// How the process ended; none where it did not, or is late.
  adapters::Death end() const { return over_ && !late_ ? fate().end() : adapters::Death::none; }

 private:
  using Clock = std::chrono::steady_clock;
  bool read_records();

  std::size_t task_;
  Clock::time_point end_;
  adapters::Pipe records_;
  std::optional<adapters::KeptProcess> process_;
  std::string said_;
  bool late_ = false;  ///< it took too long in all
  bool over_ = false;  ///< the process has ended
};

}  // namespace assay::drivers
