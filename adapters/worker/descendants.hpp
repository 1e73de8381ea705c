// SPDX-License-Identifier: BSD-3-Clause
// Processes that a model has started, for the one that watches it.
#pragma once

#include <sys/types.h>

namespace assay::adapters {

/// From now on a process whose parents have ended becomes a child of this one, whatever it has done to get away.
void adopt_orphans();

/// Whether this process has a child that is none of `own` and still runs.
bool has_other_child(pid_t own);

/// Ends every child of this process, and theirs. In bounded time: what starts new ones faster than they can be ended
/// may get away. True: there were such that still ran.
bool end_descendants();

}  // namespace assay::adapters
