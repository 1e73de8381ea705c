// SPDX-License-Identifier: BSD-3-Clause
// What foreign code does to the process that runs it, beside computing: harmless to a worker, not to a host.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <memory>
#include <string>

#include "adapters/foreign/written_inputs.hpp"

namespace assay::adapters {

/// Or-ed, with the inputs that foreign models wrote to (WrittenInput).
enum Habit : Habits {
  no_habit = 0,
  folder_changed = 1,
  output_closed = 2,
  processes_left = 4,
  locale_changed = 8,
  signals_taken = 16,
  signals_blocked = 32,
  denormals_left_flushed = Habits{1} << 32,
  precision_left = Habits{1} << 33,
  x87_left = Habits{1} << 34,
  files_forbidden = Habits{1} << 35,
  timer_left = Habits{1} << 36,
  limits_changed = Habits{1} << 37,
  environment_changed = Habits{1} << 38,
  files_left = Habits{1} << 39,
  rounding_left = Habits{1} << 40,
  traps_left = Habits{1} << 41,
  scheduling_changed = Habits{1} << 42,
  watcher_signalled = Habits{1} << 43,
  group_left = Habits{1} << 44,
  streams_hurried = Habits{1} << 45,
};

/// "changes the folder of the process, closes or redirects its standard output"; empty where it does nothing.
std::string habit_words(Habits habits);

/// How a process was before foreign code ran in it.
class ProcessWatch {
 public:
  ProcessWatch();
  ~ProcessWatch();
  /// Since then, of those that can still be seen.
  Habits habits() const;
  /// The same for a process that looks again and again: at a few signals at a time, since each costs a system call.
  Habits habits_so_far();

 private:
  struct Settings;
  bool takes(int signal) const;
  Habits habits_but_signals() const;

  std::unique_ptr<const Settings> before_;
  int next_signal_ = 1;  ///< to be looked at
};

/// Private pages of a process that could be written to, in bytes: what it has asked for, touched or not. 0: unknown.
std::uint64_t data_bytes(pid_t process);

}  // namespace assay::adapters
