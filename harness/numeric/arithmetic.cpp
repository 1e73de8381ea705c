// SPDX-License-Identifier: BSD-3-Clause
#include "harness/numeric/arithmetic.hpp"

#include <atomic>
#include <cfenv>

#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

namespace assay {

namespace {

std::atomic<std::uint32_t> noted{arithmetic_kept};

}  // namespace

void reset_arithmetic() { std::fesetenv(FE_DFL_ENV); }

#if defined(__x86_64__)

/// Both units: std::fegetround and fegetexcept ask the x87 unit alone, and doubles are computed by the other.
std::uint32_t changes_of_arithmetic() {
  constexpr unsigned flush_to_zero = 0x8000, denormals_are_zero = 0x0040, rounding = 0x6000, masks = 0x1f80;
  constexpr unsigned x87_rounding = 0x0c00, x87_precision = 0x0300, x87_masks = 0x003f;
  std::uint16_t x87 = 0;
  __asm__ volatile("fnstcw %0" : "=m"(x87));
  const unsigned sse = _mm_getcsr();
  std::uint32_t changes = arithmetic_kept;
  if ((sse & rounding) != 0 || (x87 & x87_rounding) != 0) changes |= rounding_changed;
  if ((sse & masks) != masks || (x87 & x87_masks) != x87_masks) changes |= traps_enabled;
  if ((sse & (flush_to_zero | denormals_are_zero)) != 0) changes |= denormals_flushed;
  if ((x87 & x87_precision) != x87_precision) changes |= precision_changed;
  return changes;
}

bool x87_in_use() {
  struct {
    std::uint32_t control, status, tags, others[4];
  } environment = {};
  __asm__ volatile("fnstenv %0\n\tfldenv %0" : "+m"(environment));
  return (environment.tags & 0xffff) != 0xffff;
}

#else

bool x87_in_use() { return false; }

std::uint32_t changes_of_arithmetic() {
  std::uint32_t changes = arithmetic_kept;
  if (std::fegetround() != FE_TONEAREST) changes |= rounding_changed;
  if (::fegetexcept() != 0) changes |= traps_enabled;
  return changes;
}

#endif

std::uint32_t put_arithmetic_right() {
  const std::uint32_t changes = changes_of_arithmetic();
  if (changes == arithmetic_kept) return changes;
  noted.fetch_or(changes, std::memory_order_relaxed);
  reset_arithmetic();
  return changes;
}

std::uint32_t noted_arithmetic() { return noted.load(std::memory_order_relaxed); }

std::string arithmetic_words(std::uint32_t changes) {
  if (changes & traps_enabled) return "leaves floating-point traps enabled";
  if (changes & rounding_changed) return "changes the rounding mode of the process";
  return {};
}

}  // namespace assay
