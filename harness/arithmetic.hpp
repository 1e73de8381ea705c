// SPDX-License-Identifier: BSD-3-Clause
// The floating-point arithmetic of a thread: foreign code may change it, and everything after it computes otherwise.
#pragma once

#include <cstdint>
#include <string>

namespace assay {

/// Or-ed.
enum Arithmetic : std::uint32_t { arithmetic_kept = 0, rounding_changed = 1, traps_enabled = 2, denormals_flushed = 4 };

/// Of this thread, against the default: to nearest, no traps, gradual underflow.
std::uint32_t changes_of_arithmetic();

/// Back to the default.
void reset_arithmetic();

/// "changes the rounding mode of the process"; empty where no result can have suffered: flushed denormals are put right
/// and pass.
std::string arithmetic_words(std::uint32_t changes);

}  // namespace assay
