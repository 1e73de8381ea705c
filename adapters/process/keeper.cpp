// SPDX-License-Identifier: BSD-3-Clause
// The keeper of a process: it runs no foreign code, so that whatever the process does to itself, its end is told, what
// it has started ends with it, and its files go.
#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/signalfd.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <optional>
#include <utility>

#include "adapters/process/descendants.hpp"
#include "adapters/process/kept_process.hpp"
#include "adapters/process/process_watch.hpp"
#include "harness/material/progress_mark.hpp"

namespace assay::adapters {

namespace {

/// The signals that a keeper leaves, and a file that can be read when a child has ended.
class DeferredSignals {
 public:
  explicit DeferredSignals(bool all) {
    sigset_t of_children, deferred;
    ::sigemptyset(&of_children);
    ::sigaddset(&of_children, SIGCHLD);
    all ? ::sigfillset(&deferred) : ::sigemptyset(&deferred);
    ::sigaddset(&deferred, SIGCHLD);
    ::sigprocmask(all ? SIG_SETMASK : SIG_BLOCK, &deferred, &before_);
    deaths_ = ::signalfd(-1, &of_children, SFD_CLOEXEC | SFD_NONBLOCK);
  }
  /// In the process.
  void undo() const {
    ::close(deaths_);
    ::sigprocmask(SIG_SETMASK, &before_, nullptr);
  }
  int deaths() const { return deaths_; }
  void drain() const {
    signalfd_siginfo ignored;
    while (::read(deaths_, &ignored, sizeof ignored) > 0) continue;
  }

 private:
  sigset_t before_;
  int deaths_;
};

class Keeper {
 public:
  Keeper(const Kept& what, Fate& fate, int lifeline)
      : what_(what),
        fate_(fate),
        lifeline_(lifeline),
        time_limit_(fate.time_limit),
        memory_limit_(fate.memory_limit),
        signals_(what.defers_signals) {}

  int live() {
    if (what_.folders) folder_.emplace(what_.folders);
    if (folder_ && folder_->path().empty() && !stands_apart)
      return give_up(("a folder in " + temporary_folder()).c_str());
    if (folder_) std::snprintf(fate_.folder, sizeof fate_.folder, "%s", folder_->path().c_str());
    adopt_orphans();
    int heard[2] = {-1, -1};
    if (what_.hears && !high_pipe(heard)) return give_up("pipe");
    const pid_t keeper = ::getpid();
    process_ = ::fork();
    if (process_ < 0) return give_up("fork");
    if (process_ == 0) {
      ::close(heard[0]);
      begin(heard[1], keeper);
    }
    ::close(heard[1]);
    for (const int file : what_.files_of_process) ::close(file);
    if (what_.own_group) ::setpgid(process_, process_);  // whichever comes first
    hear_from(heard[0]);
    watch();
    return 0;
  }

 private:
  /// In the process, before any foreign code.
  [[noreturn]] void begin(int prints, pid_t keeper) {
    if (what_.own_group) ::setpgid(0, 0);  // what it starts can be ended with it
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != keeper) leave_now(0);
    const rlimit no_core{0, 0};
    ::setrlimit(RLIMIT_CORE, &no_core);
    signals_.undo();
    ::close(lifeline_);
    if (prints >= 0) send_streams_to(prints, prints), ::close(prints);
    if (folder_ && !folder_->enter()) {
      claim_shortage(folder_->path().c_str());
      leave_now(1);
    }
    while (fate_.begin.load() == 0) wait_while(fate_.begin, 0);
    what_.work(fate_);
    leave_now(0);
  }

  void hear_from(int file) {
    heard_ = file;
    if (heard_ >= 0) ::fcntl(heard_, F_SETFL, O_NONBLOCK);
    if (memory_limit_ > 0) begin_bytes_ = data_bytes(process_);
    fate_.process = static_cast<std::uint32_t>(process_);
    wake_all(fate_.process);
  }

  /// Until the process has ended, or the host has let go.
  void watch() {
    const bool looks = heard_ >= 0 || time_limit_ > 0 || memory_limit_ > 0;
    constexpr int look_ms = 20;  // how often limits are looked at
    for (;;) {
      pollfd files[] = {{lifeline_, POLLIN, 0}, {signals_.deaths(), POLLIN, 0}, {heard_, POLLIN, 0}};
      ::poll(files, 3, looks ? look_ms : -1);  // a negative number is no file
      hear();
      signals_.drain();
      int status = 0;
      rusage usage = {};
      const int kinds = WNOHANG | (what_.ends_when_stopped ? WUNTRACED : 0);
      if (::wait4(process_, &status, kinds, &usage) == process_ && is_end(status)) return tell_end(status, usage);
      if (files[0].revents & (POLLHUP | POLLERR)) return end_process();
      if (const Death limit = limit_exceeded(); limit != Death::none) {
        end_process();
        return tell(limit, 0);
      }
    }
  }

  /// A stop by the user, at the terminal, is none.
  static bool is_end(int status) { return !WIFSTOPPED(status) || WSTOPSIG(status) == SIGSTOP; }

  /// With all that it has started.
  void end_process() {
    ::kill(-process_, SIGKILL);
    ::kill(process_, SIGKILL);
    while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) continue;
    end_descendants();
    hear();
  }

  Death limit_exceeded() {
    const std::int64_t since = fate_.busy_since.load();
    if (since == 0) {
      if (!settled_ && memory_limit_ > 0) begin_bytes_ = std::max(begin_bytes_, data_bytes(process_));
      return Death::none;
    }
    settled_ = true;
    if (time_limit_ > 0 && static_cast<double>(now_ns() - since) > 1e9 * time_limit_) return Death::time_limit;
    if (memory_limit_ > 0 && data_bytes(process_) > begin_bytes_ + memory_limit_) return Death::memory;
    return Death::none;
  }

  void tell_end(int status, const rusage& usage) {
    const auto seconds = [](const timeval& t) {
      return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    fate_.processor_s = seconds(usage.ru_utime) + seconds(usage.ru_stime);
    if (WIFSTOPPED(status)) {
      end_process();
      return tell(Death::signal, WSTOPSIG(status));
    }
    const bool of_group = ::kill(-process_, SIGKILL) == 0, others = end_descendants();
    if (of_group || others) fate_.habits.fetch_or(processes_left);
    hear();
    if (WIFSIGNALED(status)) return tell(Death::signal, WTERMSIG(status));
    tell(Death::exit, WEXITSTATUS(status));
  }

  /// What the process has said of its own end goes first.
  void tell(Death death, int number) {
    const std::uint32_t claim = fate_.claim.load();
    std::uint32_t none = 0;
    if (claim != static_cast<std::uint32_t>(Death::shortage)) fate_.death_number = number;
    fate_.death.compare_exchange_strong(none, claim ? claim : static_cast<std::uint32_t>(death));
    wake_all(fate_.reply);
    wake_all(fate_.death);
  }

  /// Of the call that has just failed.
  void claim_shortage(const char* call) {
    fate_.death_number = errno;
    std::snprintf(fate_.death_words, sizeof fate_.death_words, "%s: %s", call, std::strerror(errno));
    fate_.claim = static_cast<std::uint32_t>(Death::shortage);
  }

  int give_up(const char* call) {
    claim_shortage(call);
    tell(Death::shortage, 0);
    return 1;
  }

  void hear() {
    char text[1 << 14];
    for (int rounds = 0; heard_ >= 0 && rounds < 64; ++rounds) {
      const ssize_t length = ::read(heard_, text, sizeof text);
      if (length == 0) ::close(std::exchange(heard_, -1));
      if (length <= 0) return;
      fate_.output.add(text, static_cast<std::size_t>(length));
    }
  }

  const Kept& what_;
  Fate& fate_;
  int lifeline_;
  double time_limit_;           ///< [s]
  std::uint64_t memory_limit_;  ///< bytes
  DeferredSignals signals_;
  std::optional<OwnFolder> folder_;
  pid_t process_ = -1;
  int heard_ = -1;
  bool settled_ = false;  ///< what it began with is known
  std::uint64_t begin_bytes_ = 0;
};

}  // namespace

int keep(const Kept& what, Fate& fate, int lifeline) {
  if (what.own_group) ::setpgid(0, 0);  // not ended by the terminal's Ctrl-C
  std::signal(SIGCHLD, SIG_DFL);        // who ignores it gets no status
  return Keeper(what, fate, lifeline).live();
}

}  // namespace assay::adapters
