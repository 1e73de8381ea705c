// SPDX-License-Identifier: BSD-3-Clause
// What a worker can still say of its own end.
#pragma once

#include <string>

#include "adapters/worker/control.hpp"

namespace assay::adapters {

/// From here on a signal next to the end of the stack is told as an overflow of it, one next to zero as a null pointer,
/// and routines by which a model ends the analysis (XIT) are told by name.
void mark_crashes(Control& control);

/// Whether that was called in this process, or in the one that it is a copy of.
bool crashes_are_marked();

/// The model ends the process by its own word.
[[noreturn]] void end_by_word(const char* words);

}  // namespace assay::adapters
