// SPDX-License-Identifier: BSD-3-Clause
// What foreign code does to the process that runs it, beside computing: harmless to a worker, not to a host.
#pragma once

#include <sys/types.h>

#include <array>
#include <csignal>
#include <cstdint>
#include <string>

namespace assay::adapters {

/// Or-ed, with the inputs that foreign models wrote to (WrittenInput).
enum Habit : std::uint32_t {
  no_habit = 0,
  folder_changed = 1,
  output_closed = 2,
  processes_left = 4,
  locale_changed = 8,
  signals_taken = 16,
};

/// "changes the folder of the process, closes or redirects its standard output"; empty where it does nothing.
std::string habit_words(std::uint32_t habits);

/// How a process was before foreign code ran in it.
class ProcessWatch {
 public:
  ProcessWatch();
  std::uint32_t habits() const;  ///< since then, of those that can still be seen

 private:
  struct File {
    dev_t device = 0;
    ino_t node = 0;
    friend bool operator==(const File&, const File&) = default;
  };
  static constexpr std::array signals{SIGINT, SIGTERM, SIGFPE, SIGSEGV, SIGABRT, SIGILL};
  static File folder();
  static bool watcher_has_others();
  static File open_file(int number);
  static std::array<void (*)(int), signals.size()> handlers();

  File folder_, output_, errors_;
  std::array<void (*)(int), signals.size()> handlers_;
  char decimal_point_;
  std::uint32_t written_;  ///< WrittenInput of models before
};

/// Private pages of a process that could be written to, in bytes: what it has asked for, touched or not. 0: unknown.
std::uint64_t data_bytes(pid_t process);

}  // namespace assay::adapters
