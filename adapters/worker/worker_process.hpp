// SPDX-License-Identifier: BSD-3-Clause
// A worker, as its host sees it: `assay worker`, a kept process that answers calls. It ends with its host, whatever
// ends the host, and leaves nothing behind.
#pragma once

#include <functional>
#include <string>

#include "adapters/process/kept_process.hpp"
#include "adapters/worker/hand_over.hpp"

namespace assay::adapters {

struct WorkerStart {
  std::string task;        ///< what it is to do, as the program's `worker` verb reads it
  std::string build = {};  ///< of this code: a program of another one refuses the task
  WorkerLimits limits = {};
  int columns = -1;  ///< memory to share besides, -1: none
};

/// Where the worker finds what its host has opened for it.
enum WorkerFile : int { memory_file = 3, lifeline_file = 4, columns_file = 5 };

/// The layout of the shared memory: Control, the task, and the arrays of a call.
inline constexpr std::size_t task_offset = 16384, task_size = 1 << 20, arrays_offset = task_offset + task_size;
inline constexpr std::size_t shared_size = std::size_t{1} << 28;
static_assert(sizeof(Control) <= task_offset);

/// At its end, whatever else differs between two builds, a program of another build says which one it is.
inline constexpr std::size_t refusal_size = 4096;

class WorkerProcess {
 public:
  /// Throws std::system_error where no process can be made.
  explicit WorkerProcess(const WorkerStart& start);

  Control& control() const { return *static_cast<Control*>(kept_.memory().data()); }
  /// Of the arrays of a call, 64-byte aligned.
  char* arrays() const { return static_cast<char*>(kept_.memory().data()) + arrays_offset; }
  std::size_t arrays_size() const { return kept_.memory().size() - arrays_offset - refusal_size; }

  /// Hands over, and comes back when it is done. False: the worker is dead. Throws std::system_error where its program
  /// is of another build.
  bool call(std::uint32_t operation);

  /// Whether it has ended, of one that is not called. Throws as call() does.
  bool is_over() const;

  bool is_ours() const { return kept_.is_ours(); }
  bool dead() const { return control().end() != Death::none; }
  bool killed() const { return control().was_killed(); }
  /// "died of signal 11 (Segmentation fault)", "did not come back within 20 s", with the last line that it printed.
  std::string how_it_ended() const;
  /// What was printed; the middle of much is left out, and how much is said.
  std::string output() const { return control().output.text(); }

 private:
  bool wait();
  bool is_dead() const;
  void refuse_other_build() const;

  WorkerLimits limits_;
  std::string build_;
  KeptProcess kept_;
  std::uint32_t posted_ = 0;  ///< number of the last request: the model can write into the page
  SpinHabit habit_;
};

/// The program whose `worker` verb is started: this one, or the `assay` beside it. In a library $ASSAY_PROGRAM, else
/// the one of its build folder, that of its installation, or what $PATH leads to.
std::string worker_program();

/// Asked while a host waits: true lets it give up. Null at first.
inline std::function<bool()> give_up_waiting;

}  // namespace assay::adapters
