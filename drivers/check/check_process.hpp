// SPDX-License-Identifier: BSD-3-Clause
// The battery in processes of its own: a model that crashes, exits or never comes back costs one verdict.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "adapters/foreign/written_inputs.hpp"
#include "adapters/process/kept_process.hpp"
#include "drivers/check/check_report.hpp"
#include "harness/material/progress_mark.hpp"

namespace assay::drivers {

/// What is told on the way: which material it is, before its first test, the id of every test that begins, and what it
/// has found.
struct CheckReporter {
  std::function<void(const CheckedMaterial&)> material;
  std::function<void(const std::string& id)> begins;
  std::function<void(const check::TestResult& result)> ends;
  std::function<adapters::Habits()> habits;  ///< or-ed adapters::Habit: what the model has done to its process so far
  bool first_calls = false;                  ///< the process is the check's own, and nothing has called the model in it
  std::function<void()> over;                ///< the model has run: its instances are kept until all is told
};

struct CheckTask {
  std::string name;  ///< of the material, for a report that does not come
  std::function<CheckedMaterial(const CheckReporter& reporter)> run;
  adapters::WorkerLimits limits = {};  ///< of one call of a foreign model, and of memory
  bool strain_is_asked = false;        ///< then no advice asks for another one
};

struct CheckProcesses {
  int at_once = 1;
  double limit_s = 600;                                 ///< for each
  std::function<void(std::size_t done)> progress = {};  ///< whenever one has ended
  /// Again and again while one runs: how many of its tests have begun, and the last of them.
  std::function<void(std::size_t begun, const std::string& test)> at_work = {};
};

/// Each task in a process of its own, in the order given. One that ends without a report has failed the test in which
/// it ended. Throws Interrupted, SystemError.
std::vector<CheckedMaterial> check_in_processes(const std::vector<CheckTask>& tasks, const CheckProcesses& how);

/// How what a process prints begins that had no memory for a report.
inline constexpr const char* no_memory_words = "no memory is left";

/// The process in which one material is checked, as its parent knows it.
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
