// SPDX-License-Identifier: BSD-3-Clause
// The floating-point arithmetic of a thread: foreign code may change it, and everything after it computes otherwise.
#pragma once

#include <cstdint>
#include <string>

namespace assay {

/// Or-ed.
enum Arithmetic : std::uint32_t {
  arithmetic_kept = 0,
  rounding_changed = 1,   ///< of double precision, or of the x87 unit
  traps_enabled = 2,      ///< likewise
  denormals_flushed = 4,  ///< results (FTZ) or operands (DAZ)
  precision_changed = 8,  ///< of the x87 unit, which computes long double: below 64 bits
};

/// Of this thread, against the default: to nearest, no traps, gradual underflow, 64 bits.
std::uint32_t changes_of_arithmetic();

/// Back to the default.
void reset_arithmetic();

/// What a call has changed, which is put right; noted for `noted_arithmetic`.
std::uint32_t put_arithmetic_right();

/// Whether a register of the x87 unit holds a number between calls, where none should: eight are all that there are.
bool x87_in_use();

/// All that calls have changed in this process so far.
std::uint32_t noted_arithmetic();

/// "changes the rounding mode of the process"; empty where no result can have suffered: flushed denormals and a changed
/// precision are put right and pass.
std::string arithmetic_words(std::uint32_t changes);

}  // namespace assay
