// SPDX-License-Identifier: BSD-3-Clause
// A material's library runs in this process: where it ends the process or crashes, that must be said and must not look
// like success.
#pragma once

namespace assay::drivers {

/// While one lives, exit(), and what main.cpp makes of _exit(), print one line and end with status 3; so do SIGSEGV,
/// SIGABRT, SIGBUS, SIGFPE and SIGILL where nobody else handles them. Only in this process, not in its children. At
/// most one at a time.
class ExitGuard {
 public:
  ExitGuard();
  ExitGuard(const ExitGuard&) = delete;
  ExitGuard& operator=(const ExitGuard&) = delete;
  ~ExitGuard();
};

/// Ends the process at once; no handler, no buffer, no guard. Async-signal-safe.
[[noreturn]] void leave_process(int status) noexcept;

/// The same for a caller that may be a guarded model: then the line is printed and the status is 3. Async-signal-safe.
[[noreturn]] void leave_process_guarded(int status) noexcept;

}  // namespace assay::drivers
