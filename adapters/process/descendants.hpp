// SPDX-License-Identifier: BSD-3-Clause
// Processes that a model has started, for the one that watches it.
#pragma once

#include <sys/types.h>

#include <cstddef>

namespace assay::adapters {

/// The beginning of /proc/PROCESS/NAME; empty where there is none.
struct ProcText {
  ProcText(pid_t process, const char* name);
  char text[4096];  ///< ends with a zero
  std::size_t length = 0;
};

/// From now on a process whose parents have ended becomes a child of this one, whatever it has done to get away.
void adopt_orphans();

/// Whether the parent of this process is one that has called it.
bool parent_adopts();

/// Waits for a child that is about to end; lets it go on where it was stopped, and kills it after five seconds.
void await_end(pid_t child);

/// Ends every child of this process, and theirs. In bounded time: what starts new ones faster than they can be ended
/// may get away. True: there were such that still ran.
bool end_descendants();

}  // namespace assay::adapters
