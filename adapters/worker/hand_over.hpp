// SPDX-License-Identifier: BSD-3-Clause
// How a host and its worker hand calls over, and how long either looks before it sleeps.
//
//   host                                   shared memory                    worker
//   copies what the call reads  ------->   arrays (call_arrays.hpp)
//   counts `request` on, wakes  ------->   Control                  ----->  calls the model's function
//   waits, looks at the process <-------   point, habits, a claim   <-----  marks what it does
//                               <-------   arrays, message          <-----  copies what the call wrote
//   goes on                     <-------   `reply`                  <-----  counts `reply` on, wakes
//
// What is called is an Operation (operations.hpp). A worker that dies leaves its fate (fate.hpp): the call fails with
// words of how, and the next one goes to a new worker.
#pragma once

#include <atomic>
#include <cstdint>

#include "adapters/process/fate.hpp"
#include "harness/material/progress_mark.hpp"

namespace assay::adapters {

inline constexpr std::size_t no_point = ~std::size_t{0};  ///< the model takes its batch as a whole

/// The page of a worker. request and reply count the calls: a side waits until the other has counted on.
struct Control : Fate {
  std::atomic<std::uint32_t> request;
  std::atomic<std::uint32_t> operation;  ///< Operation, or of a task
  std::atomic<std::uint32_t> spin_us;    ///< how long both sides look before they sleep: calls come fast
  std::atomic<std::uint32_t> host_sleeps, worker_sleeps;
  std::atomic<std::uint64_t> wake_ups;  ///< of either side, by the system
  // the worker's marks
  std::atomic<std::size_t> point;         ///< of the batch, that is being worked on; or no_point
  std::atomic<std::uint32_t> arithmetic;  ///< or-ed Arithmetic of the last call
  std::atomic<std::int64_t> busy_ns;      ///< spent in the last request
};

/// Sleeps while the word has that value, `milliseconds` at most (negative: for ever). `sleeps` says so meanwhile: who
/// changes the word and then finds 0 there need not ask the system to wake anybody.
inline void sleep_while(std::atomic<std::uint32_t>& word, std::uint32_t value, std::atomic<std::uint32_t>& sleeps,
                        int milliseconds = -1) {
  sleeps.store(1);
  wait_while(word, value, milliseconds);
  sleeps.store(0);
}

/// Wakes who sleeps for the word, and counts that.
inline void wake_sleeper(Control& control, std::atomic<std::uint32_t>& word, const std::atomic<std::uint32_t>& sleeps) {
  if (sleeps.load() == 0) return;
  wake_all(word);
  control.wake_ups.fetch_add(1);
}

/// Looks for so long whether the word has changed; true when it has.
inline bool changes_within(const std::atomic<std::uint32_t>& word, std::uint32_t value, std::uint32_t microseconds) {
  if (microseconds == 0) return false;
  const std::int64_t end = now_ns() + std::int64_t{1000} * microseconds;
  do {
    for (int k = 0; k < 64; ++k) {
      if (word.load(std::memory_order_acquire) != value) return true;
#if defined(__x86_64__)
      __builtin_ia32_pause();
#endif
    }
  } while (now_ns() < end);
  return false;
}

/// Whether it pays to look for an answer before one sleeps: to wake a sleeping core costs ten times what a short call
/// does, but where no core is free, looking keeps the other side from its work. Looks as long as most answers come
/// while it does; else sleeps at once, and tries again now and then.
class SpinHabit {
 public:
  static constexpr std::uint32_t microseconds = 30;  ///< of a look
  static constexpr int trials = 4, rest = 256;       ///< calls

  /// How long to look for the answer to the next call [us].
  std::uint32_t look() {
    if (resting_ == 0) return microseconds;
    if (--resting_ == 0) came_ = missed_ = 0;
    return 0;
  }

  /// Whether the answer came in that time; of calls that looked.
  void note(bool came) {
    ++(came ? came_ : missed_);
    if (came_ + missed_ < trials) return;
    if (missed_ > came_) resting_ = rest;
    came_ = missed_ = 0;
  }

 private:
  int came_ = 0, missed_ = 0, resting_ = 0;
};

}  // namespace assay::adapters
