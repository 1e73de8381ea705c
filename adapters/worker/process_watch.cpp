// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/worker/process_watch.hpp"

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <clocale>
#include <cstdio>

#include "adapters/foreign/written_inputs.hpp"
#include "adapters/worker/descendants.hpp"
#include "harness/progress_mark.hpp"

namespace assay::adapters {

ProcessWatch::ProcessWatch()
    : folder_(folder()),
      output_(open_file(STDOUT_FILENO)),
      errors_(open_file(STDERR_FILENO)),
      handlers_(handlers()),
      decimal_point_(*std::localeconv()->decimal_point),
      written_(written_inputs()) {}

ProcessWatch::File ProcessWatch::folder() {
  struct stat found = {};
  return ::stat(".", &found) == 0 ? File{found.st_dev, found.st_ino} : File{};
}

ProcessWatch::File ProcessWatch::open_file(int number) {
  struct stat found = {};
  return ::fstat(number, &found) == 0 ? File{found.st_dev, found.st_ino} : File{};
}

std::array<void (*)(int), ProcessWatch::signals.size()> ProcessWatch::handlers() {
  std::array<void (*)(int), signals.size()> found = {};
  for (std::size_t k = 0; k < signals.size(); ++k) {
    struct sigaction action = {};
    sigaction(signals[k], nullptr, &action);
    found[k] = action.sa_handler;
  }
  return found;
}

/// A process that has got away from its parents is a child of whoever watches this one.
bool ProcessWatch::watcher_has_others() {
  constexpr std::int64_t pause_ns = 20'000'000;  // of a look that takes 20 us
  static std::int64_t last_ns = -pause_ns;
  static bool others = false;
  if (!parent_adopts() || now_ns() - last_ns < pause_ns) return others;
  last_ns = now_ns();
  char name[64];
  const auto watcher = static_cast<int>(::getppid());
  std::snprintf(name, sizeof name, "/proc/%d/task/%d/children", watcher, watcher);
  std::FILE* file = std::fopen(name, "r");
  if (!file) return false;
  for (int process = 0; std::fscanf(file, "%d", &process) == 1;) others = others || process != ::getpid();
  std::fclose(file);
  return others;
}

std::uint32_t ProcessWatch::habits() const {
  std::uint32_t found = no_habit;
  if (folder() != folder_) found |= folder_changed;
  if (open_file(STDOUT_FILENO) != output_ || open_file(STDERR_FILENO) != errors_) found |= output_closed;
  siginfo_t child = {};
  if (::waitid(P_ALL, 0, &child, WEXITED | WNOHANG | WNOWAIT) == 0 || watcher_has_others()) found |= processes_left;
  if (*std::localeconv()->decimal_point != decimal_point_) found |= locale_changed;
  if (handlers() != handlers_) found |= signals_taken;
  return found | (written_inputs() & ~written_);
}

std::string habit_words(std::uint32_t habits) {
  struct Words {
    Habit habit;
    const char* words;
  };
  constexpr Words all[] = {{folder_changed, "changes the folder of the process"},
                           {output_closed, "closes or redirects standard output"},
                           {processes_left, "leaves processes behind"},
                           {locale_changed, "changes the decimal point of the process"},
                           {signals_taken, "takes over signals of the process"}};
  std::string text;
  for (const Words& each : all) {
    if (habits & each.habit) text += (text.empty() ? "" : ", ") + std::string(each.words);
  }
  const std::string inputs = written_input_names(habits);
  if (!inputs.empty()) text += (text.empty() ? "" : ", ") + ("writes to its inputs (" + inputs + ")");
  return text;
}

std::uint64_t data_bytes(pid_t process) {
  char name[64];
  std::snprintf(name, sizeof name, "/proc/%d/statm", static_cast<int>(process));
  std::FILE* file = std::fopen(name, "r");
  if (!file) return 0;
  unsigned long long size = 0, resident = 0, shared = 0, text = 0, library = 0, data = 0;
  const int read =
      std::fscanf(file, "%llu %llu %llu %llu %llu %llu", &size, &resident, &shared, &text, &library, &data);
  std::fclose(file);
  return read == 6 ? data * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE)) : 0;
}

}  // namespace assay::adapters
