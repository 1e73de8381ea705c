// SPDX-License-Identifier: BSD-3-Clause
// A material's library runs in this process: where it ends the process or crashes, that must be said and must not look
// like success.
#pragma once

#include <atomic>

namespace assay::drivers {

/// The status with which a process means to end, for one that waits for it. Lies in memory that both share.
struct Parting {
  std::atomic<int> status;
  std::atomic<bool> is_told;
};

/// While one lives, exit(), and what main.cpp makes of _exit(), print one line and end with status 3; so do SIGSEGV,
/// SIGABRT, SIGBUS, SIGFPE and SIGILL where nobody else handles them. Only in this process, not in its children. At
/// most one at a time.
class ExitGuard {
 public:
  ExitGuard();
  ExitGuard(const ExitGuard&) = delete;
  ExitGuard& operator=(const ExitGuard&) = delete;
  ~ExitGuard();

  /// From here on every status by which this program leaves is told there too, of the process that
  /// move_to_this_process() names. Null where there is no memory.
  static const Parting* share_last_word();

  /// After a fork(): guards this process in place of its parent. A crash is told as the library's change where that is
  /// one that has been written to since.
  static void move_to_this_process(const char* library);
};

/// What is to be written is written: what a library does to this process from here on changes its status no more.
/// Async-signal-safe.
void results_are_whole(int status) noexcept;

/// Ends the process at once; no handler, no buffer, no guard. Async-signal-safe.
[[noreturn]] void leave_process(int status) noexcept;

/// The same for a caller that may be a guarded model: then the line is printed and the status is 3. Async-signal-safe.
[[noreturn]] void leave_process_guarded(int status) noexcept;

/// A model ends the thread that calls it: where that is the first one of a guarded process, or of one that runs a model
/// apart, the process ends with words of that. Otherwise it comes back.
void leave_thread_guarded() noexcept;

}  // namespace assay::drivers
