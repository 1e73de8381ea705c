// SPDX-License-Identifier: BSD-3-Clause
// The host's side of a worker: a process of its own for code that is not trusted. It ends with its host, whatever ends
// the host, and leaves nothing behind.
#pragma once

#include <sys/types.h>

#include <functional>
#include <string>

#include "adapters/worker/control.hpp"
#include "adapters/worker/shared_memory.hpp"
#include "adapters/worker/spin_habit.hpp"
#include "adapters/worker/worker_limits.hpp"

namespace assay::adapters {

struct WorkerStart {
  std::string task;  ///< what it is to do, as the program's `worker` verb reads it
  WorkerLimits limits = {};
  int records = -1;  ///< a file that it may write to, -1: none
  int columns = -1;  ///< memory to share besides, -1: none
};

/// Where the worker finds what its host has opened for it.
enum WorkerFile : int { memory_file = 3, lifeline_file = 4, records_file = 5, columns_file = 6 };

/// The page's layout: Control, the task, and the arrays of a call.
inline constexpr std::size_t task_offset = 16384, task_size = 1 << 20, arrays_offset = task_offset + task_size;
inline constexpr std::size_t shared_size = std::size_t{1} << 28;
static_assert(sizeof(Control) <= task_offset);

class WorkerProcess {
 public:
  /// Throws std::system_error where no process can be made.
  explicit WorkerProcess(const WorkerStart& start);
  WorkerProcess(const WorkerProcess&) = delete;
  WorkerProcess& operator=(const WorkerProcess&) = delete;
  ~WorkerProcess();

  Control& control() { return *static_cast<Control*>(memory_.data()); }
  const Control& control() const { return *static_cast<const Control*>(memory_.data()); }
  /// Of the arrays of a call, 64-byte aligned.
  char* arrays() const { return static_cast<char*>(memory_.data()) + arrays_offset; }
  std::size_t arrays_size() const { return memory_.size() - arrays_offset; }

  /// Hands over and returns at once; `wait` comes back when it is done. False: the worker is dead.
  void post(std::uint32_t operation);
  bool wait();
  bool call(std::uint32_t operation) { return post(operation), wait(); }

  bool dead() const { return control().death.load() != 0; }
  /// By SIGKILL, or with its warden: by the model, or by somebody from outside, as the system where memory is short.
  bool killed() const;
  /// "died of signal 11 (Segmentation fault)", "did not come back within 20 s", with the last line that it printed.
  std::string how_it_ended() const;
  /// What was printed; the middle of much is left out, and how much is said.
  std::string output() const;

 private:
  bool is_dead();
  std::string death_words() const;
  bool warden_is_gone() const;
  bool warden_is_stuck() const;
  void remove_folder() const;

  SharedMemory memory_;
  pid_t warden_ = -1;
  int lifeline_ = -1;
  double time_limit_, memory_limit_;
  std::uint32_t posted_ = 0;  ///< number of the last request: the model can write into the page
  SpinHabit habit_;
};

/// The program whose `worker` verb is started: this one, or the `assay` beside it.
std::string worker_program();

/// Asked while a host waits: true lets it give up. Null at first.
inline std::function<bool()> give_up_waiting;

}  // namespace assay::adapters
