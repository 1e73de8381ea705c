// SPDX-License-Identifier: BSD-3-Clause
// Files of ours beside foreign code that closes what it can think of: their numbers are high.
#pragma once

namespace assay::adapters {

/// A copy of a file. Its number is high where the system lets it be, and in any case beyond those of the standard
/// streams and of WorkerFile. -1: none can be had.
int high_copy(int file);

/// A pipe of such files, which no other program inherits. False: none can be had, and errno says why.
bool high_pipe(int ends[2]);

}  // namespace assay::adapters
