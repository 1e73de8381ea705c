// SPDX-License-Identifier: BSD-3-Clause
// Foreign code may fork() and come back twice. The second comes back in a copy of the process, which must not answer.
#pragma once

#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>

namespace assay {

/// A page that the system wipes in every copy of the process; null: copies are not told apart.
inline std::atomic<const volatile unsigned char*> own_mark{nullptr};

/// To be called in a process that is to run foreign code, and again in each that it forks on purpose for that.
inline void own_this_process() {
  static void* const page = [] {
    const auto size = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
    void* made = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (made != MAP_FAILED && ::madvise(made, size, MADV_WIPEONFORK) == 0) return made;
    return static_cast<void*>(nullptr);  // a kernel before 4.14
  }();
  if (!page) return;
  *static_cast<unsigned char*>(page) = 1;
  own_mark = static_cast<const volatile unsigned char*>(page);
}

/// After foreign code: ends a copy of the process that owns itself, without a word.
inline void end_a_copy() {
  const volatile unsigned char* mark = own_mark.load(std::memory_order_relaxed);
  if (!mark || *mark != 0) return;
  for (;;) ::syscall(SYS_exit_group, 0);
}

}  // namespace assay
