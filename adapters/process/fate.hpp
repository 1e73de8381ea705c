// SPDX-License-Identifier: BSD-3-Clause
// The page that a host, its kept process and the keeper between them share: what the process may take, what it is at,
// and how it came to its end.
#pragma once

#include <atomic>
#include <csignal>
#include <cstdint>

#include "adapters/process/printed.hpp"

namespace assay::adapters {

/// What a process that runs foreign code may take.
struct WorkerLimits {
  double seconds = 20;   ///< of one call
  double gigabytes = 4;  ///< of memory, beyond what it begins with
};

/// How a process came to its end.
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
  lost,        ///< the keeper itself is gone
  shortage,    ///< the system did not give what a process needs: words say what, number is that of errno
};

inline constexpr std::size_t words_size = 512;

/// All zero at first. The process can write into it: what must stand is read before it is at work.
struct Fate {
  // by the host, before the start
  double time_limit;                 ///< of one call [s]; 0: none
  std::uint64_t memory_limit;        ///< bytes beyond what the process had at its start; 0: any
  std::atomic<std::uint32_t> begin;  ///< 1: the process may begin
  // marks of the process
  std::atomic<std::int64_t> busy_since;  ///< monotonic [ns] of the call that runs; 0: none
  std::atomic<std::uint32_t> phase;      ///< CallPhase of the model
  std::atomic<std::uint64_t> habits;     ///< or-ed Habit so far
  std::atomic<std::uint32_t> claim;      ///< Death, as the process itself saw it come
  // by the keeper
  std::atomic<std::uint32_t> process;  ///< its number; 0: there is none yet
  std::atomic<std::uint32_t> reply;    ///< woken when the end is told
  std::atomic<std::uint32_t> death;    ///< Death
  std::int32_t death_number;
  double processor_s;  ///< of the process and those that it waited for [s]
  char death_words[words_size];
  char folder[words_size];  ///< of the process, absolute
  KeptOutput output;

  Death end() const { return static_cast<Death>(death.load()); }
  /// By SIGKILL, or with its keeper: by the model, or by somebody from outside, as the system where memory is short.
  bool was_killed() const { return end() == Death::lost || (end() == Death::signal && death_number == SIGKILL); }
  /// Whether a signal ended it; death_number is which.
  bool ended_by_signal() const {
    return end() == Death::signal || end() == Death::stack || end() == Death::null || end() == Death::unaligned;
  }
  /// As a shell says it: 128 + signal where it died of one.
  int exit_status() const {
    return end() == Death::exit ? death_number : 128 + (ended_by_signal() ? death_number : SIGKILL);
  }
};
static_assert(std::atomic<std::uint32_t>::is_always_lock_free && std::atomic<std::int64_t>::is_always_lock_free);

/// Sleeps while a shared word has that value; comes back on a wake, a signal, or after `milliseconds` (negative:
/// never).
void wait_while(std::atomic<std::uint32_t>& word, std::uint32_t value, int milliseconds = -1);
void wake_all(std::atomic<std::uint32_t>& word);

/// By the process: from here on a signal next to the end of the stack is told as an overflow of it, one next to zero as
/// a null pointer, and routines by which a model ends the analysis (XIT) are told by name.
void mark_crashes(Fate& fate);

/// Whether that was called in this process, or in the one that it is a copy of.
bool crashes_are_marked();

/// The model ends the process by its own word.
[[noreturn]] void end_by_word(const char* words);

/// "was ended by signal 11: the stack overflowed", "ended the process with status 0", or the model's own words.
std::string words_of_end(const Fate& fate);

}  // namespace assay::adapters
