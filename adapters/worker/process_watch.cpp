// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/worker/process_watch.hpp"

#include <fcntl.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <clocale>
#include <csignal>
#include <cstdio>
#include <limits>

#include "adapters/worker/descendants.hpp"
#include "harness/material/progress_mark.hpp"
#include "harness/numeric/arithmetic.hpp"

namespace assay::adapters {

ProcessWatch::ProcessWatch()
    : folder_(folder()),
      output_(open_file(STDOUT_FILENO)),
      errors_(open_file(STDERR_FILENO)),
      dispositions_(dispositions()),
      blocked_(blocked()),
      decimal_point_(*std::localeconv()->decimal_point),
      written_(written_inputs()),
      arithmetic_(noted_arithmetic()),
      forbidden_(forbidden()),
      has_timer_(has_timer()),
      limits_(limits()),
      environment_(environment()),
      lowest_free_file_(lowest_free_file()),
      scheduling_(scheduling()),
      group_(::getpgrp()),
      signals_of_watcher_(signals_of_watcher()) {}

ProcessWatch::File ProcessWatch::folder() {
  struct stat found = {};
  return ::stat(".", &found) == 0 ? File{found.st_dev, found.st_ino} : File{};
}

ProcessWatch::File ProcessWatch::open_file(int number) {
  struct stat found = {};
  return ::fstat(number, &found) == 0 ? File{found.st_dev, found.st_ino} : File{};
}

ProcessWatch::Disposition ProcessWatch::disposition(int signal) {
  struct sigaction action = {};
  sigaction(signal, nullptr, &action);
  constexpr int restorer = 0x04000000;  // SA_RESTORER, which the C library adds when it sets one
  const bool by_nobody = action.sa_handler == SIG_DFL || action.sa_handler == SIG_IGN;
  return {action.sa_handler, action.sa_flags & (by_nobody ? SA_NOCLDWAIT | SA_NOCLDSTOP : ~restorer)};
}

ProcessWatch::Dispositions ProcessWatch::dispositions() {
  Dispositions found;
  for (int signal = 1; signal < signal_count; ++signal) found[static_cast<std::size_t>(signal)] = disposition(signal);
  return found;
}

bool ProcessWatch::takes(int signal) const {
  return disposition(signal) != dispositions_[static_cast<std::size_t>(signal)];
}

ProcessWatch::Blocked ProcessWatch::blocked() {
  sigset_t mask;
  sigemptyset(&mask);
  ::pthread_sigmask(SIG_SETMASK, nullptr, &mask);
  Blocked found{};
  for (int signal = 1; signal < signal_count; ++signal) {
    found[static_cast<std::size_t>(signal)] = sigismember(&mask, signal) == 1;
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

Habits ProcessWatch::habits_but_signals() const {
  Habits found = no_habit;
  if (folder() != folder_) found |= folder_changed;
  if (open_file(STDOUT_FILENO) != output_ || open_file(STDERR_FILENO) != errors_) found |= output_closed;
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) {
    const int flags = ::fcntl(stream, F_GETFL);
    if (flags >= 0 && (flags & O_NONBLOCK) != 0) found |= streams_hurried;
  }
  siginfo_t child = {};
  if (::waitid(P_ALL, 0, &child, WEXITED | WNOHANG | WNOWAIT) == 0 || watcher_has_others()) found |= processes_left;
  if (*std::localeconv()->decimal_point != decimal_point_) found |= locale_changed;
  if (blocked() != blocked_) found |= signals_blocked;
  const std::uint32_t arithmetic = noted_arithmetic() & ~arithmetic_;
  if (arithmetic & rounding_changed) found |= rounding_left;
  if (arithmetic & traps_enabled) found |= traps_left;
  if (arithmetic & denormals_flushed) found |= denormals_left_flushed;
  if (arithmetic & precision_changed) found |= precision_left;
  if (x87_in_use()) found |= x87_left;
  return found | (written_inputs() & ~written_);
}

mode_t ProcessWatch::forbidden() {
  const mode_t found = ::umask(0);
  ::umask(found);
  return found;
}

bool ProcessWatch::has_timer() {
  for (const auto timer : {ITIMER_REAL, ITIMER_VIRTUAL, ITIMER_PROF}) {
    itimerval left = {};
    if (::getitimer(timer, &left) == 0 && (left.it_value.tv_sec != 0 || left.it_value.tv_usec != 0)) return true;
  }
  return false;
}

/// But for that of open files, which is ours.
ProcessWatch::Limits ProcessWatch::limits() {
  Limits found{};
  std::size_t k = 0;
  for (const auto resource :
       {RLIMIT_AS, RLIMIT_CORE, RLIMIT_CPU, RLIMIT_DATA, RLIMIT_FSIZE, RLIMIT_MEMLOCK, RLIMIT_NPROC, RLIMIT_STACK}) {
    rlimit limit = {};
    ::getrlimit(resource, &limit);
    found[k++] = limit.rlim_cur;
  }
  return found;
}

std::vector<std::string> ProcessWatch::environment() {
  std::vector<std::string> all;
  for (char** each = environ; each && *each; ++each) all.emplace_back(*each);
  std::sort(all.begin(), all.end());
  return all;
}

int ProcessWatch::lowest_free_file() {
  const int file = ::open("/", O_PATH | O_CLOEXEC);
  if (file < 0) return std::numeric_limits<int>::max();
  ::close(file);
  return file;
}

ProcessWatch::Scheduling ProcessWatch::scheduling() {
  cpu_set_t cores;
  CPU_ZERO(&cores);
  Scheduling found;
  if (::sched_getaffinity(0, sizeof cores, &cores) == 0) {
    const auto* bytes = reinterpret_cast<const unsigned char*>(&cores);
    found.cores.assign(bytes, bytes + sizeof cores);
  }
  found.policy = ::sched_getscheduler(0);
  found.niceness = ::getpriority(PRIO_PROCESS, 0);
  return found;
}

/// Of a parent that blocks its signals, as one that keeps a process does.
std::uint64_t ProcessWatch::signals_of_watcher() {
  constexpr auto bit = [](int signal) { return std::uint64_t{1} << (signal - 1); };
  constexpr std::uint64_t of_children = bit(SIGCHLD) | bit(SIGCONT);
  char name[64], line[256];
  std::snprintf(name, sizeof name, "/proc/%d/status", static_cast<int>(::getppid()));
  std::FILE* file = std::fopen(name, "r");
  if (!file) return 0;
  unsigned long long pending = 0;
  while (std::fgets(line, sizeof line, file) && std::sscanf(line, "ShdPnd: %llx", &pending) != 1) continue;
  std::fclose(file);
  return pending & ~of_children;
}

/// What is looked at once, when all is over.
Habits ProcessWatch::habits_of_settings() const {
  constexpr int a_few = 16;  // files that a model keeps open, as for its messages
  Habits found = no_habit;
  if (forbidden() != forbidden_) found |= files_forbidden;
  if (has_timer() && !has_timer_) found |= timer_left;
  if (limits() != limits_) found |= limits_changed;
  if (environment() != environment_) found |= environment_changed;
  if (lowest_free_file() - a_few > lowest_free_file_) found |= files_left;
  if (scheduling() != scheduling_) found |= scheduling_changed;
  if (::getpgrp() != group_) found |= group_left;
  if ((signals_of_watcher() & ~signals_of_watcher_) != 0) found |= watcher_signalled;
  return found;
}

Habits ProcessWatch::habits() const {
  return habits_but_signals() | habits_of_settings() | (dispositions() != dispositions_ ? signals_taken : no_habit);
}

Habits ProcessWatch::habits_so_far() {
  constexpr int at_once = 4;
  bool taken = std::any_of(deadly.begin(), deadly.end(), [this](int signal) { return takes(signal); });
  for (int k = 0; k < at_once; ++k) {
    taken = taken || takes(next_signal_);
    next_signal_ = next_signal_ + 1 < signal_count ? next_signal_ + 1 : 1;
  }
  return habits_but_signals() | (taken ? signals_taken : no_habit);
}

std::string habit_words(Habits habits) {
  struct Words {
    Habit habit;
    const char* words;
  };
  constexpr Words all[] = {
      {folder_changed, "changes the folder of the process"},
      {output_closed, "closes or redirects standard output"},
      {processes_left, "leaves processes behind"},
      {locale_changed, "changes the decimal point of the process"},
      {signals_taken, "takes over signals of the process"},
      {signals_blocked, "leaves signals blocked"},
      {rounding_left, "changes the rounding mode of the process"},
      {traps_left, "leaves floating-point traps enabled"},
      {denormals_left_flushed, "leaves denormal numbers flushed to zero"},
      {precision_left, "changes the precision of long double"},
      {x87_left, "leaves numbers in the registers of the x87 unit, as MMX does without EMMS"},
      {files_forbidden, "changes what may be done with new files (umask)"},
      {timer_left, "leaves a timer running"},
      {limits_changed, "changes the limits of the process"},
      {environment_changed, "changes the environment of the process"},
      {files_left, "leaves files open"},
      {watcher_signalled, "sends signals to the process that watches it"},
      {group_left, "leaves its process group, which Ctrl-C reaches"},
      {streams_hurried, "makes the standard streams of the process non-blocking"},
      {scheduling_changed, "changes on which cores, or how soon, the process runs (affinity, nice)"}};
  std::string text;
  for (const Words& each : all) {
    if (habits & each.habit) text += (text.empty() ? "" : ", ") + std::string(each.words);
  }
  const std::string inputs = written_input_names(static_cast<std::uint32_t>(habits));
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
