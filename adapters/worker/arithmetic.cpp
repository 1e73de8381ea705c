// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/worker/arithmetic.hpp"

#include <cfenv>

#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

#include "adapters/worker/control.hpp"

namespace assay::adapters {

namespace {

#if defined(__x86_64__)
constexpr unsigned flush_to_zero = 0x8000, denormals_are_zero = 0x0040;
#endif

}  // namespace

void reset_arithmetic() { std::fesetenv(FE_DFL_ENV); }

std::uint32_t changes_of_arithmetic() {
  std::uint32_t changes = arithmetic_kept;
  if (std::fegetround() != FE_TONEAREST) changes |= rounding_changed;
  if (::fegetexcept() != 0) changes |= traps_enabled;
#if defined(__x86_64__)
  if (_mm_getcsr() & (flush_to_zero | denormals_are_zero)) changes |= denormals_flushed;
#endif
  return changes;
}

}  // namespace assay::adapters
