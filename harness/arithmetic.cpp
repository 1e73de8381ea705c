// SPDX-License-Identifier: BSD-3-Clause
#include "harness/arithmetic.hpp"

#include <cfenv>

#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

namespace assay {

void reset_arithmetic() { std::fesetenv(FE_DFL_ENV); }

std::uint32_t changes_of_arithmetic() {
  std::uint32_t changes = arithmetic_kept;
  if (std::fegetround() != FE_TONEAREST) changes |= rounding_changed;
  if (::fegetexcept() != 0) changes |= traps_enabled;
#if defined(__x86_64__)
  constexpr unsigned flush_to_zero = 0x8000, denormals_are_zero = 0x0040;
  if (_mm_getcsr() & (flush_to_zero | denormals_are_zero)) changes |= denormals_flushed;
#endif
  return changes;
}

std::string arithmetic_words(std::uint32_t changes) {
  if (changes & traps_enabled) return "leaves floating-point traps enabled";
  if (changes & rounding_changed) return "changes the rounding mode of the process";
  return {};
}

}  // namespace assay
