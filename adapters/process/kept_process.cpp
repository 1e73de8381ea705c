// SPDX-License-Identifier: BSD-3-Clause
// A kept process, as its host sees it.
#include "adapters/process/kept_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <system_error>

#include "adapters/process/descendants.hpp"
#include "harness/material/own_process.hpp"
#include "harness/material/progress_mark.hpp"
#include "harness/numeric/stopwatch.hpp"

namespace assay::adapters {

namespace {

/// Left by a keeper that was killed. What the model may have written over its name is no folder of ours.
void remove_folder(const Fate& fate) {
  namespace fs = std::filesystem;
  const fs::path folder(std::string(fate.folder, strnlen(fate.folder, words_size)));
  std::error_code ignored;
  if (folder.is_absolute() && folder.filename().string().starts_with("assay-") && fs::is_directory(folder, ignored))
    fs::remove_all(folder, ignored);
}

/// What the copy says when the function has come back, and when it got to its end: no crash and no exit() of foreign
/// code can forge it.
constexpr char returned_mark = '-', done_mark = '+';

[[noreturn]] void run_copy(int out, const std::function<std::string()>& body, const std::function<void()>& after) {
  own_this_process();
  leave_no_marks();
  std::string text;
  try {
    text = body();
  } catch (const std::exception& error) {
    text = error.what();
  } catch (...) {
    text = "throws across the C interface";
  }
  end_a_copy();
  text += returned_mark;
  if (!write_all(out, text)) leave_now(1);
  if (after) after();
  end_a_copy();
  leave_now(write_all(out, {&done_mark, 1}) ? 0 : 1);
}

/// While it lives, children can be waited for, whose ends foreign code may have this process ignore, and orphans of
/// theirs are this process's own: a model may have ended their keeper.
class AwaitedChildren {
 public:
  AwaitedChildren() {
    struct sigaction usual = {};
    usual.sa_handler = SIG_DFL;
    ::sigaction(SIGCHLD, &usual, &action_);
    ::prctl(PR_GET_CHILD_SUBREAPER, &adopts_);
    ::prctl(PR_SET_CHILD_SUBREAPER, 1);
  }
  ~AwaitedChildren() {
    ::prctl(PR_SET_CHILD_SUBREAPER, adopts_);
    ::sigaction(SIGCHLD, &action_, nullptr);
  }
  AwaitedChildren(const AwaitedChildren&) = delete;
  AwaitedChildren& operator=(const AwaitedChildren&) = delete;

 private:
  struct sigaction action_ = {};
  int adopts_ = 0;
};

/// Until the copy has ended, whoever else may hold its pipe. What it may take does not stand in shared memory alone,
/// into which a model can write: `is_late` where it was ended here, because its keeper did not.
std::string heard_from(const KeptProcess& copy, int in, double patience_s, bool& is_late) {
  constexpr double keeper_grace_s = 2;
  const Stopwatch since;
  ::fcntl(in, F_SETFL, O_NONBLOCK);
  std::string text;
  bool open = true;
  for (bool over = false; !over;) {
    constexpr int look_ms = 10;
    if (!is_late && since.seconds() > patience_s + keeper_grace_s) is_late = true, copy.end();
    pollfd waiting{in, POLLIN, 0};
    open ? static_cast<void>(::poll(&waiting, 1, look_ms)) : wait_while(copy.fate().death, 0, look_ms);
    over = copy.is_over();  // before its last words are read
    char some[1 << 14];
    ssize_t length = 0;
    while ((length = ::read(in, some, sizeof some)) > 0) text.append(some, static_cast<std::size_t>(length));
    open = length < 0;
  }
  return text;
}

/// Takes the mark from the end of what the copy has said.
bool take_mark(std::string& text, char mark) {
  const bool there = !text.empty() && text.back() == mark;
  if (there) text.pop_back();
  return there;
}

Forked::End end_of(const Fate& fate, bool done) {
  switch (fate.end()) {
    case Death::lost:
      return Forked::End::lost;
    case Death::time_limit:
      return Forked::End::hangs;
    case Death::signal:
      return Forked::End::signal;
    case Death::shortage:
      throw std::system_error(fate.death_number, std::generic_category(), "fork");
    default:
      return done ? Forked::End::done : Forked::End::quit;
  }
}

}  // namespace

KeptProcess::KeptProcess(std::size_t bytes, bool by_fork, const WorkerLimits& limits)
    : memory_(by_fork ? SharedMemory::of_forks(bytes) : SharedMemory(bytes)),
      keeper_file_(-1),
      time_limit_(limits.seconds) {
  fate().time_limit = limits.seconds;
  fate().memory_limit = static_cast<std::uint64_t>(limits.gigabytes * 1e9);
}

KeptProcess::KeptProcess(std::size_t bytes, const WorkerLimits& limits, const Start& start)
    : KeptProcess(bytes, false, limits) {
  fate().begin = 1;
  know_keeper(start(memory_, lifeline_.in()));
  lifeline_.close_in();
}

KeptProcess::KeptProcess(const Kept& what, const WorkerLimits& limits) : KeptProcess(sizeof(Fate), true, limits) {
  ends_when_stopped_ = what.ends_when_stopped && !what.defers_signals;
  std::fflush(nullptr);  // or the copy would write it a second time
  keeper_ = ::fork();
  if (keeper_ < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (keeper_ == 0) {
    lifeline_.close_out();
    leave_now(keep(what, fate(), lifeline_.in()));
  }
  know_keeper(keeper_);
  lifeline_.close_in();
  begin();
}

void KeptProcess::know_keeper(pid_t keeper) {
  keeper_ = keeper;
  const OpenFile low(static_cast<int>(::syscall(SYS_pidfd_open, keeper, 0)));
  if (low.number() >= 0) keeper_file_.take(high_copy(low.number()));
}

/// A number may have become another process's, once somebody has waited for this one.
void KeptProcess::signal_keeper(int signal) const {
  if (keeper_file_.number() < 0) {
    ::kill(keeper_, signal);
  } else {
    ::syscall(SYS_pidfd_send_signal, keeper_file_.number(), signal, nullptr, 0);
  }
}

/// A model may end the keeper, or write over the page, as soon as it is at work.
void KeptProcess::begin() {
  constexpr int look_ms = 50;
  while (fate().process.load() == 0 && !is_over()) wait_while(fate().process, 0, look_ms);
  process_ = static_cast<pid_t>(fate().process.load());
  if (fate().end() == Death::shortage) {
    const int reason = fate().death_number;
    lifeline_.close_out();
    await_end(keeper_);
    throw std::system_error(reason, std::generic_category(), "fork");
  }
  fate().begin = 1;
  wake_all(fate().begin);
}

KeptProcess::~KeptProcess() {
  if (!is_ours()) return;
  if (process_ > 0 && fate().end() == Death::none) end();
  lifeline_.close_out();
  await_end(keeper_);
  if (process_ > 0) {
    constexpr int patience_ms = 500;  // for what is left where the keeper was killed: this process may have adopted it
    for (int waited = 0; ::kill(-process_, SIGKILL) == 0 && waited < patience_ms; ++waited) {
      if (::waitpid(-process_, nullptr, WNOHANG) == 0) ::usleep(1000);
    }
  }
  remove_folder(fate());
}

bool KeptProcess::keeper_is_gone() const {
  siginfo_t ended = {};
  const int kinds = WEXITED | WNOHANG | WNOWAIT | (ends_when_stopped_ ? WSTOPPED : 0);
  if (::waitid(P_PID, static_cast<id_t>(keeper_), &ended, kinds) == 0) {
    if (ended.si_pid != keeper_) return false;
    if (ended.si_code == CLD_STOPPED) signal_keeper(SIGKILL);
    return true;
  }
  if (errno != ECHILD) return false;
  // somebody else waits for the children of this process, or nobody may: the signal of their ends is ignored
  if (keeper_file_.number() < 0) return ::kill(keeper_, 0) != 0;
  pollfd over{keeper_file_.number(), POLLIN, 0};
  return ::poll(&over, 1, 0) > 0;
}

/// A call has taken so long that the keeper should have ended it, or no process has begun: perhaps the keeper is
/// another program.
bool KeptProcess::keeper_is_stuck() const {
  constexpr double grace_s = 5, patience_s = 60;
  const std::int64_t since = fate().busy_since.load();
  if (fate().process.load() == 0) return 1e-9 * static_cast<double>(now_ns() - made_ns_) > patience_s;
  return time_limit_ > 0 && since != 0 && 1e-9 * static_cast<double>(now_ns() - since) > time_limit_ + grace_s;
}

bool KeptProcess::is_over() const {
  if (fate().death.load() != 0) return true;
  if (!ends_when_stopped_) signal_keeper(SIGCONT);  // a model may have stopped it
  if (keeper_is_stuck()) signal_keeper(SIGKILL);
  std::uint32_t none = 0;
  if (keeper_is_gone()) fate().death.compare_exchange_strong(none, static_cast<std::uint32_t>(Death::lost));
  return fate().death.load() != 0;
}

void KeptProcess::end() const {
  ::kill(-process_, SIGKILL);
  if (!is_over()) ::kill(process_, SIGKILL);
}

void KeptProcess::ask_to_end() const {
  if (!is_over()) ::kill(process_, SIGTERM);
}

Forked in_a_child(const std::function<std::string()>& body, const ForkedHow& how) {
  const AwaitedChildren awaited;
  Pipe said;
  const auto work = [&](Fate& fate) {
    fate.busy_since = now_ns();
    said.close_in();
    run_copy(said.out(), body, how.after);
  };
  const KeptProcess copy({.work = work,
                          .hears = false,
                          .own_group = how.apart,
                          .defers_signals = how.apart,
                          .ends_when_stopped = true,
                          .files_of_process = {said.out()}},
                         {.seconds = how.patience_s, .gigabytes = 0});
  said.close_out();
  Forked found;
  bool is_late = false;
  found.text = heard_from(copy, said.in(), how.patience_s, is_late);
  const bool at_end = found.text.ends_with(std::string{returned_mark, done_mark});
  const bool done = at_end && take_mark(found.text, done_mark);
  found.returned = take_mark(found.text, returned_mark);
  found.end = is_late ? Forked::End::hangs : end_of(copy.fate(), done);
  if (found.end == Forked::End::lost) found.returned = false, found.text.clear();  // it may have been cut short
  if (found.end == Forked::End::signal) found.signal = copy.fate().death_number;
  return found;
}

void leave_now(int status) {
  for (;;) ::syscall(SYS_exit_group, status);
}

}  // namespace assay::adapters
