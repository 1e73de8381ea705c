// SPDX-License-Identifier: BSD-3-Clause
// The process in which one material is checked, as its parent knows it.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <string>

#include "adapters/worker/control.hpp"
#include "adapters/worker/kept_output.hpp"
#include "drivers/check/check_keeper.hpp"
#include "drivers/check/check_process.hpp"
#include "harness/material/progress_mark.hpp"

namespace assay::drivers {

/// How what a process prints begins that had no memory for a report.
inline constexpr const char* no_memory_words = "no memory is left";

struct Child {
  using Clock = std::chrono::steady_clock;

  std::size_t task = 0;
  Keeper keeper;
  int in = -1;     ///< its records
  int heard = -1;  ///< what the model prints
  Clock::time_point end;
  adapters::WorkerLimits limits;
  std::string said;  ///< its records so far
  std::unique_ptr<adapters::KeptOutput> output;
  adapters::Control* control = nullptr;  ///< shared: of a foreign call that runs, and how the end was seen to come
  std::uint64_t begin_bytes = 0;         ///< of memory
  enum class Excess { none, time, call, memory } excess = Excess::none;  ///< for which it was ended
  adapters::Death claim = adapters::Death::none;                         ///< how it saw its end come
  std::string words;                                                     ///< by which a model ended itself
  CallPhase phase = CallPhase::updating;                                 ///< in which its end came
  bool over = false;                                                     ///< the process has ended, with `status`
  bool lost = false;                                                     ///< and took its keeper with it
  int status = 0;
};

/// Throws SystemError where no process can be made.
Child start_child(const std::vector<CheckTask>& tasks, std::size_t task, double limit_s);

/// What it takes too much of, by now.
Child::Excess excess_of(const Child& child);

/// Whether the process has ended, by now.
bool is_over(Child& child);

/// Reads what there is. True: its records have come to an end.
bool read_records(Child& child);
void read_output(Child& child);

/// Ends the process, with all that it has started, and whatever it was in.
void end_process(const Child& child);

/// Ends and forgets it, with its files.
void release(Child& child);

}  // namespace assay::drivers
