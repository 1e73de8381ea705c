// SPDX-License-Identifier: BSD-3-Clause
// Waiting for a word in memory that processes share.
#pragma once

#include <linux/futex.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <climits>
#include <cstdint>
#include <ctime>

namespace assay::adapters {

/// Sleeps while the word has that value; comes back on a wake, a signal, or after `milliseconds` (negative: never).
/// `sleeps` says so meanwhile: who changes the word and then finds 0 there need not ask the system to wake anybody.
inline void wait_while(std::atomic<std::uint32_t>& word, std::uint32_t value, std::atomic<std::uint32_t>& sleeps,
                       int milliseconds = -1) {
  const timespec limit{milliseconds / 1000, (milliseconds % 1000) * 1000000L};
  sleeps.store(1);
  ::syscall(SYS_futex, reinterpret_cast<std::uint32_t*>(&word), FUTEX_WAIT, value, milliseconds < 0 ? nullptr : &limit,
            nullptr, 0);
  sleeps.store(0);
}

inline void wake_all(std::atomic<std::uint32_t>& word) {
  ::syscall(SYS_futex, reinterpret_cast<std::uint32_t*>(&word), FUTEX_WAKE, INT_MAX, nullptr, nullptr, 0);
}

/// Whether anybody had to be woken.
inline bool wake_sleeper(std::atomic<std::uint32_t>& word, const std::atomic<std::uint32_t>& sleeps) {
  if (sleeps.load() == 0) return false;
  wake_all(word);
  return true;
}

/// Looks for so long whether the word has changed; true when it has.
inline bool changes_within(const std::atomic<std::uint32_t>& word, std::uint32_t value, std::uint32_t microseconds) {
  if (microseconds == 0) return false;
  timespec start{}, now{};
  ::clock_gettime(CLOCK_MONOTONIC, &start);
  do {
    for (int k = 0; k < 64; ++k) {
      if (word.load(std::memory_order_acquire) != value) return true;
#if defined(__x86_64__)
      __builtin_ia32_pause();
#endif
    }
    ::clock_gettime(CLOCK_MONOTONIC, &now);
  } while ((now.tv_sec - start.tv_sec) * 1000000L + (now.tv_nsec - start.tv_nsec) / 1000 <
           static_cast<long>(microseconds));
  return false;
}

}  // namespace assay::adapters
