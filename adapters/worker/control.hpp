// SPDX-License-Identifier: BSD-3-Clause
// The page that a host, its worker and the worker's warden share. The host spawns the warden, a process that runs no
// foreign code; the warden starts the worker proper, hears what it prints, watches its limits and cleans up after it.
#pragma once

#include <atomic>
#include <cstdint>

#include "adapters/worker/kept_output.hpp"
#include "harness/assay_material.h"

namespace assay::adapters {

/// How a worker came to its end.
enum class Death : std::uint32_t {
  none,
  signal,      ///< number: the signal
  exit,        ///< number: the status
  time_limit,  ///< a call took longer than allowed
  memory,      ///< the process took more than allowed
  stack,       ///< a signal next to the end of the stack
  null,        ///< a signal at an address next to zero
  unaligned,   ///< a signal at an address that is not a multiple of the size of what lies there
  ended,       ///< by the model's own word, as XIT; words say which
  given_up,    ///< the host was interrupted while it waited
  lost,        ///< the warden itself is gone
  shortage,    ///< the system did not give what a worker needs; words say what
};

inline constexpr std::size_t words_size = 512;
inline constexpr std::size_t no_point = ~std::size_t{0};       ///< the model takes its batch as a whole
inline constexpr const char* worker_folder = "assay-worker-";  ///< how the names of workers' folders begin

struct Control {
  // host -> worker and back; both count, and are waited for
  std::atomic<std::uint32_t> request, reply;
  std::atomic<std::uint32_t> operation;  ///< Operation, or of a task
  std::atomic<std::uint32_t> spin_us;    ///< how long both sides look before they sleep: calls come fast
  std::atomic<std::uint32_t> host_sleeps, worker_sleeps;
  std::atomic<std::uint64_t> wake_ups;  ///< of either side, by the system
  // limits, set by the host before the start
  double time_limit;           ///< of one call [s]
  std::uint64_t memory_limit;  ///< bytes beyond what the worker had at its start
  // the worker's marks
  std::atomic<std::int64_t> busy_since;   ///< monotonic [ns] of the call that runs; 0: none
  std::atomic<std::uint32_t> phase;       ///< CallPhase of the model
  std::atomic<std::size_t> point;         ///< of the batch, that is being worked on; or no_point
  std::atomic<std::uint32_t> arithmetic;  ///< or-ed Arithmetic of the last call
  std::atomic<std::int64_t> busy_ns;      ///< spent in the last request
  std::atomic<std::uint64_t> habits;      ///< or-ed Habit so far
  std::atomic<std::uint32_t> claim;       ///< Death, as the worker itself saw it come
  // the end, written by the warden
  std::atomic<std::uint32_t> death;  ///< Death
  std::int32_t death_number;
  char death_words[words_size];
  KeptOutput output;
  char reason[words_size];  ///< of a request that failed
  char folder[words_size];  ///< of the worker, absolute
};
static_assert(std::atomic<std::uint32_t>::is_always_lock_free && std::atomic<std::int64_t>::is_always_lock_free);

}  // namespace assay::adapters
