// SPDX-License-Identifier: BSD-3-Clause
// A kept process, as its host sees it.
#include "adapters/process/kept_process.hpp"

#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "adapters/process/descendants.hpp"
#include "harness/material/progress_mark.hpp"

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

}  // namespace

KeptProcess::KeptProcess(std::size_t bytes, bool by_fork, const WorkerLimits& limits)
    : memory_(by_fork ? SharedMemory::of_forks(bytes) : SharedMemory(bytes)), time_limit_(limits.seconds) {
  fate().time_limit = limits.seconds;
  fate().memory_limit = static_cast<std::uint64_t>(limits.gigabytes * 1e9);
}

KeptProcess::KeptProcess(std::size_t bytes, const WorkerLimits& limits, const Start& start)
    : KeptProcess(bytes, false, limits) {
  fate().begin = 1;
  keeper_ = start(memory_, lifeline_.in());
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
  lifeline_.close_in();
  begin();
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
  if (::waitid(P_PID, static_cast<id_t>(keeper_), &ended, kinds) != 0 || ended.si_pid != keeper_) return false;
  if (ended.si_code == CLD_STOPPED) ::kill(keeper_, SIGKILL);
  return true;
}

/// A call has taken so long that the keeper should have ended it.
bool KeptProcess::keeper_is_stuck() const {
  constexpr double grace_s = 5;
  const std::int64_t since = fate().busy_since.load();
  return time_limit_ > 0 && since != 0 && 1e-9 * static_cast<double>(now_ns() - since) > time_limit_ + grace_s;
}

bool KeptProcess::is_over() const {
  if (fate().death.load() != 0) return true;
  if (!ends_when_stopped_) ::kill(keeper_, SIGCONT);  // a model may have stopped it
  if (keeper_is_stuck()) ::kill(keeper_, SIGKILL);
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

void leave_now(int status) {
  for (;;) ::syscall(SYS_exit_group, status);
}

}  // namespace assay::adapters
