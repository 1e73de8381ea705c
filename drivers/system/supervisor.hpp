// SPDX-License-Identifier: BSD-3-Clause
// Code of others in this process may end it in any way: at its exit, by becoming another program, by a signal that
// nobody can catch. So who was called waits, and a process of its own works on.
#pragma once

#include <string>

#include "adapters/foreign/written_inputs.hpp"

namespace assay::drivers {

/// From here on this process may wait for another: to be called by the program alone, before all else.
void allow_supervision();

/// To be called before a library is loaded into this process. It comes back in a child, which does the work; this
/// process waits, passes signals on, ends what the library has started, and ends with the child's last word, or with
/// status 3 and one line where there is none. Once a process, and only where it is allowed; otherwise nothing happens.
/// Throws SystemError where no process can be made.
void supervise(const std::string& library);

/// From here on the models' instances are kept. A supervised process begins so.
void keep_instances();

/// Destroys those that were kept: to be called when all is written.
void release_instances();

/// What was done to the child's process since then, or-ed adapters::Habit.
adapters::Habits supervised_habits();

}  // namespace assay::drivers
