// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/system/supervisor.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <iostream>
#include <mutex>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "adapters/library.hpp"
#include "adapters/process/descendants.hpp"
#include "adapters/process/private_files.hpp"
#include "drivers/system/exit_guard.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/own_files.hpp"
#include "harness/material/own_process.hpp"
#include "harness/material/thrown.hpp"

namespace assay::drivers {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

pid_t allowed = 0;  ///< the process that may wait

/// For what libraries do when a process exits; a sanitizer looks for leaks then.
constexpr std::chrono::seconds patience{adapters::is_sanitized ? 30 : 2};
constexpr int passed_on[] = {SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGUSR1, SIGUSR2, SIGALRM, SIGXCPU};

sigset_t awaited_signals() {
  sigset_t set;
  ::sigemptyset(&set);
  ::sigaddset(&set, SIGCHLD);
  for (const int signal : passed_on) ::sigaddset(&set, signal);
  return set;
}

/// How the child came to its end.
struct Ended {
  int status = 0;         ///< as of waitpid()
  int passed = 0;         ///< the last signal that was passed on to it
  int by_child = 0;       ///< the last signal that it has sent itself
  bool late = false;      ///< it did not end by itself
  bool replaced = false;  ///< it became another program
};

bool is_another_program(pid_t process) {
  std::error_code code;
  const fs::path own = fs::read_symlink("/proc/self/exe", code);
  const fs::path other = fs::read_symlink("/proc/" + std::to_string(process) + "/exe", code);
  return !code && own != other;
}

/// Tells once of a child that has stopped while its watcher has not: a terminal stops both.
class StoppedChild {
 public:
  void look(pid_t child) {
    siginfo_t info = {};
    if (::waitid(P_PID, static_cast<id_t>(child), &info, WSTOPPED | WCONTINUED | WNOHANG) == 0 && info.si_pid != 0) {
      signal_ = info.si_code == CLD_STOPPED ? info.si_status : 0;
      since_ = Clock::now();
    } else if (signal_ != 0 && Clock::now() - since_ >= std::chrono::seconds(1)) {
      const int signal = std::exchange(signal_, 0);
      std::fprintf(stderr,
                   "warning: process %d of this program is stopped (signal %d, %s), from outside or by the material's "
                   "library; to go on: kill -CONT %d\n",
                   static_cast<int>(child), signal, strsignal(signal), static_cast<int>(child));
    }
  }

 private:
  int signal_ = 0;  ///< that has stopped it, as long as nobody has told
  Clock::time_point since_;
};

/// Waits for a signal for as long as a look may be late. A terminal sends its signals to both, unless the child has
/// left their group. What the child sends itself is a model's doing: nobody wants the run to end.
void pass_signal_on(pid_t child, const sigset_t& awaited, Ended& ended) {
  const timespec pause{0, 50'000'000};
  siginfo_t sent = {};
  const int signal = ::sigtimedwait(&awaited, &sent, &pause);
  if (signal <= 0 || signal == SIGCHLD) return;
  if (sent.si_code <= 0 && sent.si_pid == child) {
    ended.by_child = signal;
    return;
  }
  ended.passed = signal;
  if (sent.si_code <= 0 || ::getpgid(child) != ::getpgrp()) ::kill(child, signal);
  ::kill(child, SIGCONT);  // what is stopped takes no other signal
}

Ended end_of(pid_t child, const Parting& word) {
  const sigset_t awaited = awaited_signals();
  Ended ended;
  std::optional<Clock::time_point> told;
  StoppedChild stopped;
  for (auto looked = Clock::now(); ::waitpid(child, &ended.status, WNOHANG) == 0;) {
    pass_signal_on(child, awaited, ended);
    stopped.look(child);
    const auto now = Clock::now();
    if (!told && word.is_told) told = now;
    ended.late = told && now - *told > patience;
    if (now - looked > std::chrono::milliseconds(500)) {
      looked = now;
      ended.replaced = ended.replaced || is_another_program(child);
    }
    if (ended.late || (ended.replaced && !told)) ::kill(child, SIGKILL);
  }
  return ended;
}

std::string signal_words(int signal) { return "signal " + std::to_string(signal) + ", " + strsignal(signal); }

std::string how(const Ended& ended) {
  if (ended.replaced) return "became another program";
  if (ended.late) return "did not end";
  if (WIFSIGNALED(ended.status)) return "crashed (" + signal_words(WTERMSIG(ended.status)) + ")";
  return "ended with status " + std::to_string(WEXITSTATUS(ended.status));
}

/// Of one that has left no word.
std::string line_of(const Ended& ended) {
  constexpr const char* by_library = ", most likely by the material's library";
  if (ended.replaced) return std::string("the process became another program") + by_library;
  if (!WIFSIGNALED(ended.status)) return std::string("the process was ended from inside") + by_library;
  if (WTERMSIG(ended.status) == SIGKILL)
    return "the process was killed (signal 9): from outside, as the system does if memory is short, or by the "
           "material's library";
  return "the process crashed (" + signal_words(WTERMSIG(ended.status)) + ")" + by_library;
}

[[noreturn]] void die_of(int signal) {
  std::signal(signal, SIG_DFL);
  ::raise(signal);
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  leave_process(128 + signal);
}

/// The settings of the user's terminal, which outlive the program: how they were when this was made. Where this process
/// is not the one in front, or has no terminal, nothing is done.
class OwnTerminal {
 public:
  OwnTerminal()
      : file_(::open("/dev/tty", O_RDWR | O_NOCTTY | O_CLOEXEC | O_NONBLOCK)),
        is_known_(file_.number() >= 0 && ::tcgetpgrp(file_.number()) == ::getpgrp() &&
                  ::tcgetattr(file_.number(), &before_) == 0) {}

  /// Puts them right; whether something was changed.
  bool put_right() const {
    termios now = {};
    if (!is_known_ || ::tcgetattr(file_.number(), &now) != 0 || alike(now, before_)) return false;
    sigset_t of_writers, blocked;  // who is no longer in front would be stopped
    ::sigemptyset(&of_writers);
    ::sigaddset(&of_writers, SIGTTOU);
    ::sigprocmask(SIG_BLOCK, &of_writers, &blocked);
    ::tcsetattr(file_.number(), TCSANOW, &before_);
    ::sigprocmask(SIG_SETMASK, &blocked, nullptr);
    return true;
  }

 private:
  static bool alike(const termios& a, const termios& b) {
    return a.c_iflag == b.c_iflag && a.c_oflag == b.c_oflag && a.c_cflag == b.c_cflag && a.c_lflag == b.c_lflag &&
           std::ranges::equal(a.c_cc, b.c_cc);
  }

  adapters::OpenFile file_;
  termios before_ = {};  ///< above what fills it in
  bool is_known_;
};

[[noreturn]] void watch(pid_t child, const Parting& word, const OwnTerminal& terminal) {
  const Ended ended = end_of(child, word);
  if (adapters::end_descendants()) std::fputs("warning: the model leaves processes behind, which were ended\n", stderr);
  if (terminal.put_right())
    std::fputs("warning: the model changes the settings of the terminal, which were put right\n", stderr);
  if (ended.by_child != 0) {
    std::fprintf(stderr, "warning: the model sends %s to the process that watches it\n",
                 signal_words(ended.by_child).c_str());
  }
  if (word.is_told) {
    const bool as_told = WIFEXITED(ended.status) && WEXITSTATUS(ended.status) == word.status;
    if (!as_told || ended.late) {
      std::fprintf(stderr, "warning: the process %s when it was to exit, after all was written: %s\n",
                   how(ended).c_str(), "most likely by the material's library");
    }
    leave_process(word.status);
  }
  if (WIFSIGNALED(ended.status) && WTERMSIG(ended.status) == ended.passed) die_of(ended.passed);
  std::fprintf(stderr, "assay: %s\n", line_of(ended).c_str());
  leave_process(3);
}

struct KeptInstances {
  std::mutex guard;
  std::vector<std::pair<void (*)(void*), void*>> all;  ///< how each is destroyed
};

/// Never destroyed: a material may go after all that is static here.
KeptInstances& kept() {
  static auto* const instances = new KeptInstances;
  return *instances;
}

void keep(void (*destroy)(void*), void* self) {
  const std::lock_guard lock(kept().guard);
  kept().all.emplace_back(destroy, self);
}

}  // namespace

void release_instances() {
  takes_instances_over = nullptr;
  for (const auto& [destroy, self] : std::exchange(kept().all, {})) destroy_marked(destroy, self);
}

void keep_instances() { takes_instances_over = keep; }

void allow_supervision() {
  std::signal(SIGCHLD, SIG_DFL);  // a caller may have ignored it: then no child could be waited for
  allowed = ::getpid();
}

// weak: libassay has another in its place
[[gnu::weak]] void supervise(const std::string& library) {
  if (allowed == 0 || allowed != ::getpid()) return;
  const Parting* word = ExitGuard::share_last_word();
  if (!word) throw_system_error("mmap");
  std::cout.flush();
  std::fflush(nullptr);  // or the child would write it a second time
  adapters::adopt_orphans();
  const sigset_t awaited = awaited_signals();
  sigset_t before;
  ::sigprocmask(SIG_BLOCK, &awaited, &before);
  const OwnTerminal terminal;  // the model may be done with it before the watching process goes on
  const pid_t child = ::fork();
  const int reason = errno;
  if (child > 0) watch(child, *word, terminal);
  ::sigprocmask(SIG_SETMASK, &before, nullptr);
  if (child < 0) throw SystemError("a library cannot be loaded: fork: " + std::generic_category().message(reason));
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != allowed) leave_process(3);
  ExitGuard::move_to_this_process(library.c_str());
  own_this_process();
  keep_instances();
  remember_files();
}

adapters::Habits supervised_habits() {
  using namespace adapters;
  return habits_of_process() & (output_closed | streams_hurried | processes_left | folder_changed | limits_changed |
                                rounding_left | traps_left);
}

}  // namespace assay::drivers
