// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/worker/warden.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <string>

#include "adapters/worker/crash_marks.hpp"
#include "adapters/worker/descendants.hpp"
#include "adapters/worker/futex.hpp"
#include "adapters/worker/high_files.hpp"
#include "adapters/worker/own_folder.hpp"
#include "adapters/worker/process_watch.hpp"
#include "adapters/worker/shortage.hpp"
#include "adapters/worker/worker_process.hpp"
#include "harness/material/own_process.hpp"
#include "harness/material/progress_mark.hpp"

namespace assay::adapters {

namespace {

constexpr int limits_look_ms = 20;  ///< how often limits are looked at

class Warden {
 public:
  /// Before there is a worker, which can write into the page.
  explicit Warden(Control& control)
      : control_(control), time_limit_(control.time_limit), memory_limit_(control.memory_limit) {}

  void watch(pid_t worker, int heard) {
    worker_ = worker, heard_ = heard;
    ::fcntl(heard_, F_SETFL, O_NONBLOCK);
    begin_bytes_ = data_bytes(worker_);
    for (;;) {
      pollfd files[] = {{lifeline_file, POLLIN, 0}, {heard_, POLLIN, 0}};
      ::poll(files, heard_open_ ? 2 : 1, limits_look_ms);
      hear();
      int status = 0;
      if (::waitpid(worker_, &status, WNOHANG) == worker_) return tell_end(status);
      if (files[0].revents & (POLLHUP | POLLERR)) return end_worker();
      if (const Death limit = limit_exceeded(); limit != Death::none) {
        end_worker();
        return tell(limit, 0);
      }
    }
  }

 private:
  /// With all that it has started.
  void end_worker() {
    ::kill(-worker_, SIGKILL);
    ::kill(worker_, SIGKILL);
    while (::waitpid(worker_, nullptr, 0) < 0 && errno == EINTR) {
    }
    end_descendants();
    hear();
  }

  Death limit_exceeded() {
    const std::int64_t since = control_.busy_since.load();
    if (since == 0) {
      begin_bytes_ = std::max(begin_bytes_, settled_ ? begin_bytes_ : data_bytes(worker_));
      return Death::none;
    }
    settled_ = true;
    if (static_cast<double>(now_ns() - since) > 1e9 * time_limit_) return Death::time_limit;
    if (data_bytes(worker_) > begin_bytes_ + memory_limit_) return Death::memory;
    return Death::none;
  }

  void tell_end(int status) {
    const bool of_group = ::kill(-worker_, SIGKILL) == 0, others = end_descendants();
    if (of_group || others) control_.habits.fetch_or(processes_left);
    hear();
    if (WIFSIGNALED(status)) return tell(Death::signal, WTERMSIG(status));
    tell(Death::exit, WEXITSTATUS(status));
  }

  /// What the worker has said of its own end goes first.
  void tell(Death death, int number) {
    const std::uint32_t claim = control_.claim.load();
    std::uint32_t none = 0;
    control_.death_number = number;
    control_.death.compare_exchange_strong(none, claim ? claim : static_cast<std::uint32_t>(death));
    wake_all(control_.reply);
  }

  void hear() {
    char text[1 << 14];
    for (int rounds = 0; heard_open_ && rounds < 64; ++rounds) {
      const ssize_t length = ::read(heard_, text, sizeof text);
      if (length == 0) heard_open_ = false;
      if (length <= 0) return;
      control_.output.add(text, static_cast<std::size_t>(length));
    }
  }

  Control& control_;
  double time_limit_;           ///< [s]
  std::uint64_t memory_limit_;  ///< bytes
  pid_t worker_ = -1;
  int heard_ = -1;
  bool heard_open_ = true, settled_ = false;
  std::uint64_t begin_bytes_ = 0;
};

/// Of the call that has just failed.
void claim_shortage(Control& control, const char* call) {
  std::snprintf(control.death_words, sizeof control.death_words, "%s: %s", call, std::strerror(errno));
  control.claim.store(static_cast<std::uint32_t>(Death::shortage));
}

/// In the worker, before any foreign code.
void settle(Control& control, const OwnFolder& folder, int heard, pid_t warden) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != warden) ::_exit(0);
  const rlimit no_core{0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  const int nothing = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  ::dup2(nothing, STDIN_FILENO);
  ::dup2(heard, STDOUT_FILENO);
  ::dup2(heard, STDERR_FILENO);
  ::close(heard);
  ::close(lifeline_file);
  if (folder.enter()) return;
  claim_shortage(control, folder.path().c_str());
  ::_exit(1);
}

[[noreturn]] void run_worker(const std::function<void(WorkerFloor&)>& work, WorkerFloor& floor) {
  int status = 0;
  own_this_process();
  try {
    work(floor);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    status = 1;
  }
  std::fflush(nullptr);
  ::_exit(status);
}

int give_up(Control& control, const char* call) {
  claim_shortage(control, call);
  control.death.store(control.claim.load());
  wake_all(control.reply);
  return 1;
}

}  // namespace

int run_warden(const std::function<void(WorkerFloor&)>& work) {
  const SharedMemory memory = SharedMemory::of_file(memory_file);
  auto* base = static_cast<char*>(memory.data());
  WorkerFloor floor{*static_cast<Control*>(memory.data()), base + task_offset, base + arrays_offset,
                    memory.size() - arrays_offset};
  const OwnFolder folder;
  if (folder.path().empty()) return give_up(floor.control, ("a folder in " + temporary_folder()).c_str());
  std::snprintf(floor.control.folder, sizeof floor.control.folder, "%s", folder.path().c_str());
  enlarge_stack(std::size_t{1} << 26);
  adopt_orphans();
  int heard[2] = {-1, -1};
  if (!high_pipe(heard)) return give_up(floor.control, "pipe");
  Warden watching(floor.control);
  const pid_t warden = ::getpid(), worker = ::fork();
  if (worker < 0) return give_up(floor.control, "fork");
  if (worker == 0) {
    ::close(heard[0]);
    settle(floor.control, folder, heard[1], warden);
    mark_crashes(floor.control);
    run_worker(work, floor);
  }
  ::close(heard[1]);
  ::close(records_file);
  ::setpgid(worker, worker);
  watching.watch(worker, heard[0]);
  return 0;
}

}  // namespace assay::adapters
