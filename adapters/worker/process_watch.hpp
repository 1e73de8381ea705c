// SPDX-License-Identifier: BSD-3-Clause
// What foreign code does to the process that runs it, beside computing: harmless to a worker, not to a host.
#pragma once

#include <sys/resource.h>
#include <sys/types.h>

#include <array>
#include <csignal>
#include <cstdint>
#include <string>
#include <vector>

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
  /// Since then, of those that can still be seen.
  Habits habits() const;
  /// The same for a process that looks again and again: at a few signals at a time, since each costs a system call.
  Habits habits_so_far();

 private:
  struct File {
    dev_t device = 0;
    ino_t node = 0;
    friend bool operator==(const File&, const File&) = default;
  };
  static constexpr std::array deadly{SIGINT, SIGTERM, SIGFPE, SIGSEGV, SIGABRT, SIGILL};
  static constexpr int signal_count = 65;  ///< signals begin at 1
  /// What a process does about a signal.
  struct Disposition {
    void (*handler)(int) = nullptr;
    int flags = 0;
    friend bool operator==(const Disposition&, const Disposition&) = default;
  };
  using Dispositions = std::array<Disposition, signal_count>;
  using Blocked = std::array<bool, signal_count>;
  using Limits = std::array<rlim_t, 8>;
  /// The cores on which a thread may run, and how soon it gets them.
  struct Scheduling {
    std::vector<unsigned char> cores;
    int policy = 0, niceness = 0;
    friend bool operator==(const Scheduling&, const Scheduling&) = default;
  };
  static File folder();
  static bool watcher_has_others();
  static File open_file(int number);
  static Disposition disposition(int signal);
  static Dispositions dispositions();
  static Blocked blocked();
  static mode_t forbidden();
  static bool has_timer();
  static Limits limits();
  static std::vector<std::string> environment();
  static int lowest_free_file();
  static Scheduling scheduling();
  static std::uint64_t signals_of_watcher();
  Habits habits_of_settings() const;
  bool takes(int signal) const;
  Habits habits_but_signals() const;

  File folder_, output_, errors_;
  Dispositions dispositions_;
  Blocked blocked_;      ///< in the thread that made this
  int next_signal_ = 1;  ///< to be looked at
  char decimal_point_;
  std::uint32_t written_, arithmetic_;  ///< WrittenInput and Arithmetic of models before
  mode_t forbidden_;                    ///< of new files
  bool has_timer_;
  Limits limits_;
  std::vector<std::string> environment_;
  int lowest_free_file_;
  Scheduling scheduling_;
  pid_t group_;
  std::uint64_t signals_of_watcher_;  ///< that its parent has got and not taken, a bit each
};

/// Private pages of a process that could be written to, in bytes: what it has asked for, touched or not. 0: unknown.
std::uint64_t data_bytes(pid_t process);

}  // namespace assay::adapters
