// SPDX-License-Identifier: BSD-3-Clause
#include "harness/numeric/arithmetic.hpp"

#include <gtest/gtest.h>

#include <cfenv>
#include <cstdint>
#include <string>

#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

#include "harness/material/material.hpp"
#include "tests/harness/elastic_material.hpp"

namespace assay::test_arithmetic {
namespace {

TEST(Arithmetic, TellsAndUndoesChanges) {
  EXPECT_EQ(changes_of_arithmetic(), arithmetic_kept);
  std::fesetround(FE_UPWARD);
  EXPECT_EQ(changes_of_arithmetic(), rounding_changed);
  ::feenableexcept(FE_INVALID);
  const std::uint32_t both = changes_of_arithmetic();
  reset_arithmetic();
  EXPECT_EQ(both, rounding_changed | traps_enabled);
  EXPECT_EQ(changes_of_arithmetic(), arithmetic_kept);
}

struct Change {
  const char* name;
  void (*made)();
  std::uint32_t told;
  bool fails;  ///< a step
};

#if defined(__x86_64__)
void set_sse(unsigned bits) { _mm_setcsr(_mm_getcsr() | bits); }
void clear_sse(unsigned bits) { _mm_setcsr(_mm_getcsr() & ~bits); }
void set_x87(std::uint16_t clear, std::uint16_t set) {
  std::uint16_t word = 0;
  __asm__ volatile("fnstcw %0" : "=m"(word));
  word = static_cast<std::uint16_t>((word & ~clear) | set);
  __asm__ volatile("fldcw %0" : : "m"(word));
}

constexpr Change changes_of_units[] = {
    {"flush_to_zero", [] { set_sse(0x8000); }, denormals_flushed, false},
    {"denormals_are_zero", [] { set_sse(0x0040); }, denormals_flushed, false},
    {"both_flushes", [] { set_sse(0x8040); }, denormals_flushed, false},
    {"doubles_rounded_upward", [] { set_sse(0x4000); }, rounding_changed, true},
    {"doubles_rounded_to_zero", [] { set_sse(0x6000); }, rounding_changed, true},
    {"long_doubles_rounded_downward", [] { set_x87(0x0c00, 0x0400); }, rounding_changed, true},
    {"long_doubles_of_53_bits", [] { set_x87(0x0300, 0x0200); }, precision_changed, false},
    {"long_doubles_of_24_bits", [] { set_x87(0x0300, 0x0000); }, precision_changed, false},
    {"traps_of_doubles", [] { clear_sse(0x0200); }, traps_enabled, true},
    {"rounding_and_flush", [] { set_sse(0xa000); }, rounding_changed | denormals_flushed, true}};

class ChangedUnit : public testing::TestWithParam<Change> {};

TEST_P(ChangedUnit, IsToldAndPutRight) {
  GetParam().made();
  EXPECT_EQ(changes_of_arithmetic(), GetParam().told);
  EXPECT_EQ(put_arithmetic_right(), GetParam().told);
  EXPECT_EQ(noted_arithmetic() & GetParam().told, GetParam().told);
  EXPECT_EQ(changes_of_arithmetic(), arithmetic_kept);
  EXPECT_EQ(arithmetic_words(GetParam().told).empty(), !GetParam().fails);
}

INSTANTIATE_TEST_SUITE_P(All, ChangedUnit, testing::ValuesIn(changes_of_units),
                         [](const auto& instance) { return std::string(instance.param.name); });
#endif

/// Neo-Hookean elasticity that leaves the processor rounding upward.
const assay_material* upward_table() {
  static const assay_material table = [] {
    assay_material t = elastic_material()->table();
    t.update = [](void* self, const assay_step* step, std::size_t n, const double* state0, double* state1,
                  double* cauchy, std::int32_t* status, double* dt_factor, char* message) {
      elastic_material()->table().update(self, step, n, state0, state1, cauchy, status, dt_factor, message);
      std::fesetround(FE_UPWARD);
    };
    return t;
  }();
  return &table;
}

TEST(Arithmetic, ChangedByAModelIsAFailureAndPutRight) {
  const Material material(upward_table(), {{"E", 1e3}, {"nu", 0.3}});
  const double F[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  double cauchy[9];
  const UpdateReport report = material.update(0, 1, 1, F, F, nullptr, nullptr, cauchy);
  EXPECT_EQ(report.worst, ASSAY_FAILED);
  EXPECT_EQ(report.message, "arithmetic: the material changes the rounding mode of the process");
  EXPECT_EQ(changes_of_arithmetic(), arithmetic_kept);
}

}  // namespace
}  // namespace assay::test_arithmetic
