// SPDX-License-Identifier: BSD-3-Clause
// One supervised process for code that is not trusted: it may crash, exit, hang, take all memory, start others, or end
// and stop what it finds. Workers, the processes of `check`, trials of libraries and compilers are kept in this way.
//
//        host                        keeper                        kept process
//     the program                runs no foreign code             runs foreign code
//     ┌───────────┐   lifeline   ┌────────────────┐     fork      ┌───────────────┐
//     │           ├─────────────>│ makes folder   ├──────────────>│ stands in the │
//     │           │              │ watches limits │<──────────────┤ folder, has a │
//     │           │              │ ends all       │   printed     │ group         │
//     └─────┬─────┘              └───────┬────────┘               └───────┬───────┘
//           │      limits, begin         │   end, number, output          │   call, phase, claim
//           └───────────────> page of shared memory: Fate <───────────────┘
//
// - The host starts the keeper by fork, or as `assay worker`, and waits for nothing but the page.
// - The keeper forks the process. It hears what the process prints and looks at its limits. When the process has
//   ended, the keeper ends what it has started, tells in the page how it ended, removes the folder and goes.
// - The lifeline is a pipe that carries nothing. It is closed when the host lets go or dies, whatever ends the host.
//   Then the keeper ends everything.
// - The process dies with its keeper. A host that finds its keeper gone says that the process is lost.
// - What the process says beside that, it says through files that its user opens: pipes of records, shared columns.
#pragma once

#include <sys/types.h>

#include <functional>
#include <vector>

#include "adapters/process/fate.hpp"
#include "adapters/process/private_files.hpp"
#include "harness/material/progress_mark.hpp"

namespace assay::adapters {

/// What a keeper keeps, and how.
struct Kept {
  std::function<void(Fate&)> work = {};           ///< of the process; where it comes back, the status is 0
  const char* folders = OwnFolder::worker_names;  ///< how the name of its folder begins; null: it has none
  bool hears = true;                              ///< what it prints is kept, and it has no standard input
  bool own_group = true;                          ///< not of the terminal's, and what it starts is of it
  bool defers_signals = false;             ///< the keeper leaves signals for the end, and goes on where it is stopped
  bool ends_when_stopped = false;          ///< a process, or a keeper, that is stopped has ended
  std::vector<int> files_of_process = {};  ///< closed in the keeper
};

/// The whole life of a keeper: to be called in a process of its own. Returns the exit status.
int keep(const Kept& what, Fate& fate, int lifeline);

/// The host's side.
class KeptProcess {
 public:
  /// Forks a keeper, and returns when the process has a number and may begin. seconds and gigabytes: 0 is no limit.
  /// Throws std::system_error where no process can be made.
  KeptProcess(const Kept& what, const WorkerLimits& limits);

  /// With a keeper that is a program: `start` gives its number, with the memory to share and the lifeline that it must
  /// inherit. The page lies at the beginning of the memory. What `start` throws, and std::system_error.
  using Start = std::function<pid_t(const SharedMemory& memory, int lifeline)>;
  KeptProcess(std::size_t bytes, const WorkerLimits& limits, const Start& start);

  KeptProcess(const KeptProcess&) = delete;
  KeptProcess& operator=(const KeptProcess&) = delete;
  /// Ends everything.
  ~KeptProcess();

  Fate& fate() const { return *static_cast<Fate*>(memory_.data()); }
  const SharedMemory& memory() const { return memory_; }

  /// False in a copy that fork has made of the process which began it: there it can be neither asked nor ended.
  bool is_ours() const { return host_ == ::getpid(); }

  /// Whether it has ended, by now: with its keeper, where that has told nothing.
  bool is_over() const;
  /// Ends the process with its group; the keeper tells it.
  void end() const;
  void ask_to_end() const;  ///< by SIGTERM

 private:
  KeptProcess(std::size_t bytes, bool by_fork, const WorkerLimits& limits);
  void begin();
  void know_keeper(pid_t keeper);
  bool keeper_is_gone() const;
  bool keeper_is_stuck() const;
  void signal_keeper(int signal) const;

  SharedMemory memory_;
  Pipe lifeline_;
  pid_t host_ = ::getpid();  ///< whose it is: a copy of that process has it not
  pid_t keeper_ = -1;
  OpenFile keeper_file_;  ///< stands for it, whoever waits for the children of this process; negative: an old kernel
  pid_t process_ = 0;     ///< as it was at first: the model can write into the page
  double time_limit_;
  std::int64_t made_ns_ = now_ns();
  bool ends_when_stopped_ = false;
};

/// How a function came to its end in a copy of this process, for code that may crash, end the process, hang, or start
/// others.
struct Forked {
  enum class End {
    done,
    signal,
    quit,
    hangs,
    lost,  ///< it ended, or stopped, the process that watches it
  } end = End::done;
  int signal = 0;         ///< that it died of
  bool returned = false;  ///< the function had come back; where not done, it is what followed that ended the copy
  std::string text;       ///< what the function returned, or what() of what it threw
};

struct ForkedHow {
  std::function<void()> after = {};  ///< what the copy runs when the function has come back
  double patience_s = 20;            ///< for both
  bool apart = false;                ///< in a group of its own, with a keeper that leaves signals for the end
};

/// Waits for it. Throws std::system_error where no process can be made.
Forked in_a_child(const std::function<std::string()>& body, const ForkedHow& how = {});

/// Ends this process at once: _exit() is the program's own.
[[noreturn]] void leave_now(int status);

}  // namespace assay::adapters
