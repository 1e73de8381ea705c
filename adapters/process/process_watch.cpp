// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/process/process_watch.hpp"

#include <fcntl.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <clocale>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <set>
#include <utility>

#include "adapters/process/descendants.hpp"
#include "adapters/process/private_files.hpp"
#include "harness/material/progress_mark.hpp"
#include "harness/numeric/arithmetic.hpp"

namespace assay::adapters {

namespace {

constexpr int signal_count = 65;  ///< signals begin at 1

using FileIdentity = std::pair<dev_t, ino_t>;

FileIdentity identity_of(int found, const struct stat& file) {
  return found == 0 ? FileIdentity{file.st_dev, file.st_ino} : FileIdentity{};
}

FileIdentity folder_now() {
  struct stat file = {};
  return identity_of(::stat(".", &file), file);
}

FileIdentity open_file(int number) {
  struct stat file = {};
  return identity_of(::fstat(number, &file), file);
}

/// What a process does about a signal.
using Disposition = std::pair<void (*)(int), int>;

Disposition disposition_of(int signal) {
  struct sigaction action = {};
  sigaction(signal, nullptr, &action);
  constexpr int restorer = 0x04000000;  // SA_RESTORER, which the C library adds when it sets one
  const bool by_nobody = action.sa_handler == SIG_DFL || action.sa_handler == SIG_IGN;
  return {action.sa_handler, action.sa_flags & (by_nobody ? SA_NOCLDWAIT | SA_NOCLDSTOP : ~restorer)};
}

/// Of each signal.
template <class Value>
std::array<Value, signal_count> of_signals(const auto& value_of) {
  std::array<Value, signal_count> found{};
  for (int signal = 1; signal < signal_count; ++signal) found[static_cast<std::size_t>(signal)] = value_of(signal);
  return found;
}

/// In the thread that asks.
std::array<bool, signal_count> blocked_now() {
  sigset_t mask;
  sigemptyset(&mask);
  ::pthread_sigmask(SIG_SETMASK, nullptr, &mask);
  return of_signals<bool>([&](int signal) { return sigismember(&mask, signal) == 1; });
}

mode_t forbidden_now() {
  const mode_t found = ::umask(0);
  ::umask(found);
  return found;
}

bool has_timer_now() {
  return std::ranges::any_of(std::array{ITIMER_REAL, ITIMER_VIRTUAL, ITIMER_PROF}, [](auto timer) {
    itimerval left = {};
    return ::getitimer(timer, &left) == 0 && (left.it_value.tv_sec != 0 || left.it_value.tv_usec != 0);
  });
}

/// But for that of open files, which is ours.
std::array<rlim_t, 8> limits_now() {
  std::array<rlim_t, 8> found{};
  std::size_t k = 0;
  for (const auto resource :
       {RLIMIT_AS, RLIMIT_CORE, RLIMIT_CPU, RLIMIT_DATA, RLIMIT_FSIZE, RLIMIT_MEMLOCK, RLIMIT_NPROC, RLIMIT_STACK}) {
    rlimit limit = {};
    ::getrlimit(resource, &limit);
    found[k++] = limit.rlim_cur;
  }
  return found;
}

std::multiset<std::string> environment_now() {
  std::multiset<std::string> all;
  for (char** each = environ; each && *each; ++each) all.emplace(*each);
  return all;
}

int lowest_free_file() {
  const OpenFile file(::open("/", O_PATH | O_CLOEXEC));
  return file.number() < 0 ? std::numeric_limits<int>::max() : file.number();
}

/// The cores on which a thread may run, and how soon it gets them.
struct Scheduling {
  std::string cores;
  int policy = ::sched_getscheduler(0), niceness = ::getpriority(PRIO_PROCESS, 0);
  Scheduling() {
    cpu_set_t set;
    CPU_ZERO(&set);
    if (::sched_getaffinity(0, sizeof set, &set) == 0) cores.assign(reinterpret_cast<const char*>(&set), sizeof set);
  }
  friend bool operator==(const Scheduling&, const Scheduling&) = default;
};

/// Of a parent that blocks its signals, as one that keeps a process does: those that it has got and not taken, a bit
/// each.
std::uint64_t signals_of_watcher() {
  constexpr auto bit = [](int signal) { return std::uint64_t{1} << (signal - 1); };
  constexpr std::uint64_t of_children = bit(SIGCHLD) | bit(SIGCONT);
  const ProcText status(::getppid(), "status");
  const char* line = std::strstr(status.text, "\nShdPnd:");
  unsigned long long pending = 0;
  if (!line || std::sscanf(line, " ShdPnd: %llx", &pending) != 1) return 0;
  return pending & ~of_children;
}

/// A process that has got away from its parents is a child of whoever watches this one.
bool watcher_has_others() {
  constexpr std::int64_t pause_ns = 20'000'000;  // of a look that takes 20 us
  static std::int64_t last_ns = -pause_ns;
  static bool others = false;
  if (!parent_adopts() || now_ns() - last_ns < pause_ns) return others;
  last_ns = now_ns();
  const std::string watcher = std::to_string(::getppid());
  const ProcText children(::getppid(), ("task/" + watcher + "/children").c_str());
  const char* at = children.text;
  for (char* end = nullptr;; at = end) {
    const long process = std::strtol(at, &end, 10);
    if (process == 0) return others;
    others = others || process != ::getpid();
  }
}

/// Whether a stream does not wait where it should.
bool is_hurried(int stream) {
  const int flags = ::fcntl(stream, F_GETFL);
  return flags >= 0 && (flags & O_NONBLOCK) != 0;
}

}  // namespace

/// As it was when this was made.
struct ProcessWatch::Settings {
  FileIdentity folder = folder_now(), output = open_file(STDOUT_FILENO), errors = open_file(STDERR_FILENO);
  std::array<Disposition, signal_count> dispositions = of_signals<Disposition>(disposition_of);
  std::array<bool, signal_count> blocked = blocked_now();
  char decimal_point = *std::localeconv()->decimal_point;
  std::uint32_t written = written_inputs(), arithmetic = noted_arithmetic();  ///< of models before
  mode_t forbidden = forbidden_now();
  bool has_timer = has_timer_now();
  std::array<rlim_t, 8> limits = limits_now();
  std::multiset<std::string> environment = environment_now();
  int free_file = lowest_free_file();
  Scheduling scheduling;
  pid_t group = ::getpgrp();
  std::uint64_t of_watcher = signals_of_watcher();
};

ProcessWatch::ProcessWatch() : before_(std::make_unique<const Settings>()) {}
ProcessWatch::~ProcessWatch() = default;

bool ProcessWatch::takes(int signal) const {
  return disposition_of(signal) != before_->dispositions[static_cast<std::size_t>(signal)];
}

Habits ProcessWatch::habits_but_signals() const {
  const std::uint32_t arithmetic = noted_arithmetic() & ~before_->arithmetic;
  siginfo_t child = {};
  const bool has_child = ::waitid(P_ALL, 0, &child, WEXITED | WNOHANG | WNOWAIT) == 0;
  const std::pair<Habit, bool> seen[] = {
      {folder_changed, folder_now() != before_->folder},
      {output_closed, open_file(STDOUT_FILENO) != before_->output || open_file(STDERR_FILENO) != before_->errors},
      {streams_hurried, is_hurried(STDOUT_FILENO) || is_hurried(STDERR_FILENO)},
      {processes_left, has_child || watcher_has_others()},
      {locale_changed, *std::localeconv()->decimal_point != before_->decimal_point},
      {signals_blocked, blocked_now() != before_->blocked},
      {rounding_left, (arithmetic & rounding_changed) != 0},
      {traps_left, (arithmetic & traps_enabled) != 0},
      {denormals_left_flushed, (arithmetic & denormals_flushed) != 0},
      {precision_left, (arithmetic & precision_changed) != 0},
      {x87_left, x87_in_use()}};
  Habits found = written_inputs() & ~before_->written;
  for (const auto& [habit, is_seen] : seen) found |= is_seen ? habit : no_habit;
  return found;
}

Habits ProcessWatch::habits() const {
  constexpr int a_few = 16;  // files that a model keeps open, as for its messages
  const std::pair<Habit, bool> seen[] = {
      {signals_taken, of_signals<Disposition>(disposition_of) != before_->dispositions},
      {files_forbidden, forbidden_now() != before_->forbidden},
      {timer_left, has_timer_now() && !before_->has_timer},
      {limits_changed, limits_now() != before_->limits},
      {environment_changed, environment_now() != before_->environment},
      {files_left, lowest_free_file() - a_few > before_->free_file},
      {scheduling_changed, Scheduling() != before_->scheduling},
      {group_left, ::getpgrp() != before_->group},
      {watcher_signalled, (signals_of_watcher() & ~before_->of_watcher) != 0}};
  Habits found = habits_but_signals();
  for (const auto& [habit, is_seen] : seen) found |= is_seen ? habit : no_habit;
  return found;
}

Habits ProcessWatch::habits_so_far() {
  constexpr int at_once = 4;
  bool taken = std::ranges::any_of(std::array{SIGINT, SIGTERM, SIGFPE, SIGSEGV, SIGABRT, SIGILL},
                                   [this](int signal) { return takes(signal); });
  for (int k = 0; k < at_once; ++k) {
    taken = taken || takes(next_signal_);
    next_signal_ = next_signal_ + 1 < signal_count ? next_signal_ + 1 : 1;
  }
  return habits_but_signals() | (taken ? signals_taken : no_habit);
}

std::string habit_words(Habits habits) {
  constexpr std::pair<Habit, const char*> all[] = {
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
  for (const auto& [habit, words] : all) {
    if (habits & habit) text += (text.empty() ? "" : ", ") + std::string(words);
  }
  const std::string inputs = written_input_names(static_cast<std::uint32_t>(habits));
  if (!inputs.empty()) text += (text.empty() ? "" : ", ") + ("writes to its inputs (" + inputs + ")");
  return text;
}

std::uint64_t data_bytes(pid_t process) {
  unsigned long long data = 0;
  const ProcText sizes(process, "statm");
  const bool is_read = std::sscanf(sizes.text, "%*u %*u %*u %*u %*u %llu", &data) == 1;
  return is_read ? data * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE)) : 0;
}

}  // namespace assay::adapters
