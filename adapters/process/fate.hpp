// SPDX-License-Identifier: BSD-3-Clause
// The page that a host, its kept process and the keeper between them share: what the process may take, what it is at,
// and how it came to its end.
#pragma once

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdint>
#include <string>

namespace assay::adapters {

/// What a process prints. The beginning and the end are kept, however much it is. Plain memory, so that processes can
/// share it; all zero: nothing printed. One writer.
struct KeptOutput {
  static constexpr std::size_t size = 4096;  ///< of either end

  std::atomic<std::uint64_t> printed;  ///< bytes in all
  char head[size], tail[size];         ///< the tail is a ring: byte k of what comes after the head at k % size

  void add(const char* text, std::size_t length) {
    std::uint64_t at = printed.load();
    for (std::size_t k = 0; k < length; ++k, ++at) (at < size ? head[at] : tail[(at - size) % size]) = text[k];
    printed.store(at);
  }

  /// With how much is left out.
  std::string text() const {
    const std::uint64_t all = printed.load();
    std::string kept(head, std::min<std::uint64_t>(all, size));
    if (all <= size) return kept;
    const std::uint64_t end = all - size, last = std::min<std::uint64_t>(end, size);
    if (end > last) kept += "\n[" + std::to_string(end - last) + " bytes are left out]\n";
    for (std::uint64_t k = end - last; k < end; ++k) kept += tail[k % size];
    return kept;
  }
};

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

/// Handlers with SA_ONSTACK have a stack of their own from here on, as far as the calling thread has none: one that
/// overflowed cannot serve.
void use_handler_stack();

/// By the process: from here on a signal next to the end of the stack is told as an overflow of it, one next to zero as
/// a null pointer, and routines by which a model ends the analysis (XIT) are told by name.
void mark_crashes(Fate& fate);

/// Whether that was called in this process, or in the one that it is a copy of.
bool crashes_are_marked();

/// The model ends the process by its own word.
[[noreturn]] void end_by_word(const char* words);

/// "was ended by signal 11: the stack overflowed", "ended the process with status 0", or the model's own words.
std::string words_of_end(const Fate& fate);

/// Of what was printed, for a message: at most 200 bytes; empty where nothing was. The list of calls that gfortran
/// prints behind its reason says nothing, nor does what it asks for at a PAUSE.
std::string last_line(std::string text);

/// Of a model that ends because it does not find a file, a clause for a message: "; it looks for 'a.txt' in its own
/// working folder: ..."; empty where nothing that was printed speaks of a file.
std::string missing_file_words(const std::string& printed);

}  // namespace assay::adapters
