// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/check/check_keeper.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/signalfd.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <filesystem>
#include <system_error>

#include "adapters/worker/descendants.hpp"
#include "drivers/system/exit_guard.hpp"
#include "drivers/system/input_error.hpp"

namespace assay::drivers {

namespace {

struct Pipe {
  Pipe() {
    if (::pipe2(ends, O_CLOEXEC) != 0) throw_system_error("pipe");
  }
  int ends[2] = {-1, -1};
};

void close_all(const std::vector<int>& files) {
  for (const int file : files) ::close(file);
}

/// A file that can be read when a child has ended. All other signals are left for the end.
int deaths_of_children() {
  sigset_t all, of_children;
  ::sigfillset(&all);
  ::sigprocmask(SIG_SETMASK, &all, nullptr);
  ::sigemptyset(&of_children);
  ::sigaddset(&of_children, SIGCHLD);
  return ::signalfd(-1, &of_children, SFD_CLOEXEC | SFD_NONBLOCK);
}

void unblock_signals() {
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
}

/// Until the process or the program has ended.
void watch(pid_t process, int deaths, int lifeline, int told) {
  for (;;) {
    pollfd files[] = {{lifeline, POLLIN, 0}, {deaths, POLLIN, 0}};
    ::poll(files, 2, 1000);
    signalfd_siginfo ignored;
    while (::read(deaths, &ignored, sizeof ignored) > 0) {
    }
    int status = 0;
    if (::waitpid(process, &status, WNOHANG) == process) {
      [[maybe_unused]] const ssize_t written = ::write(told, &status, sizeof status);
      return;
    }
    if (files[0].revents & (POLLHUP | POLLERR)) return;
  }
}

std::string new_folder(const std::string& folders) {
  std::string name = folders + "/assay-check-XXXXXX";
  return ::mkdtemp(name.data()) ? name : std::string();
}

/// What the keeper tells first; the name of the folder follows.
struct Introduction {
  pid_t process;       ///< negative: none, for this reason
  std::size_t length;  ///< of the name
};

bool introduce(int told, pid_t process, const std::string& folder) {
  const Introduction first{process, folder.size()};
  return ::write(told, &first, sizeof first) == sizeof first &&
         ::write(told, folder.data(), folder.size()) == static_cast<ssize_t>(folder.size());
}

bool hear_introduction(Keeper& keeper) {
  Introduction first{};
  if (::read(keeper.told, &first, sizeof first) != sizeof first) return false;
  if (first.process < 0) return errno = -first.process, false;
  keeper.process = first.process;
  keeper.folder.resize(first.length);
  return ::read(keeper.told, keeper.folder.data(), first.length) == static_cast<ssize_t>(first.length);
}

/// The kept process: at work once its keeper has said who it is, since a model may end the keeper at once.
[[noreturn]] void begin_work(const Keeper::Work& work, const std::string& folder, const Pipe& begin) {
  unblock_signals();
  ::close(begin.ends[1]);
  char told;
  if (::read(begin.ends[0], &told, 1) != 1) leave_process(3);
  ::close(begin.ends[0]);
  work(folder);
  leave_process(3);
}

[[noreturn]] void keep(const Keeper::Work& work, const std::vector<int>& files, int lifeline, int told,
                       const Pipe& begin, const std::string& folders) {
  ::setpgid(0, 0);  // not ended by the terminal's Ctrl-C
  adapters::adopt_orphans();
  const int deaths = deaths_of_children();
  const std::string folder = new_folder(folders);
  const pid_t process = folder.empty() ? -1 : ::fork();
  if (process < 0) introduce(told, -errno, folder);
  if (process == 0) {
    close_all({lifeline, told, deaths});
    begin_work(work, folder, begin);
  }
  close_all(files);
  ::close(begin.ends[0]);
  if (process > 0) ::setpgid(process, process);
  if (process > 0 && introduce(told, process, folder)) {
    [[maybe_unused]] const ssize_t written = ::write(begin.ends[1], "", 1);
    ::close(begin.ends[1]);
    watch(process, deaths, lifeline, told);
  }
  if (process > 0) ::kill(-process, SIGKILL);
  adapters::end_descendants();
  std::error_code ignored;
  if (!folder.empty()) std::filesystem::remove_all(folder, ignored);
  leave_process(0);
}

}  // namespace

Keeper start_kept(const Keeper::Work& work, const std::vector<int>& files, const std::vector<int>& others,
                  const std::string& folders) {
  const Pipe lifeline, told, begin;
  Keeper keeper;
  keeper.lifeline = lifeline.ends[1];
  keeper.told = told.ends[0];
  keeper.pid = ::fork();
  if (keeper.pid < 0) throw_system_error("fork");
  if (keeper.pid == 0) {
    close_all(others);
    close_all({lifeline.ends[1], told.ends[0]});
    keep(work, files, lifeline.ends[0], told.ends[1], begin, folders);
  }
  close_all({lifeline.ends[0], told.ends[1], begin.ends[0], begin.ends[1]});
  if (!hear_introduction(keeper)) throw_system_error("fork");
  ::fcntl(keeper.told, F_SETFL, O_NONBLOCK);
  return keeper;
}

bool kept_is_over(const Keeper& keeper, int& status, bool& lost) {
  const auto is_told = [&] { return ::read(keeper.told, &status, sizeof status) == sizeof status; };
  if (is_told()) return true;
  ::kill(keeper.pid, SIGCONT);  // a model may have stopped it
  siginfo_t ended = {};
  const bool gone = ::waitid(P_PID, static_cast<id_t>(keeper.pid), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 &&
                    ended.si_pid == keeper.pid;
  lost = gone && !is_told();
  return gone;
}

void dismiss(const Keeper& keeper) {
  ::close(keeper.lifeline);
  adapters::await_end(keeper.pid);
  ::close(keeper.told);
}

}  // namespace assay::drivers
