// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <array>

#include "tests/house/abi_facts.h"

namespace assay::test_abi_header {
namespace {

using Facts = std::array<std::size_t, ABI_FACT_COUNT>;

Facts facts_from(void (*source)(std::size_t*)) {
  Facts facts{};
  source(facts.data());
  return facts;
}

TEST(AbiHeader, SameLayoutInC11Cxx17AndCxx20) {
  const Facts c11 = facts_from(facts_abi_c11);
  EXPECT_EQ(c11, facts_from(facts_abi_cxx17));
  EXPECT_EQ(c11, facts_from(facts_abi_cxx20));
}

// The layout of 1.0 on x86-64 is a promise: a plug-in built from an older header keeps loading. Tables with a
// struct_size may grow at their end, nothing else may move.
TEST(AbiHeader, LayoutOf1_0IsFrozen) {
  const Facts facts = facts_from(facts_abi_c11);
  const Facts frozen{112, 48, 32, 32, 16, 16, 16, 16, 16, 8, 48, 72, 88, 96, 104, 3};
  const auto may_grow = [](std::size_t i) { return i == 0 || (i >= 4 && i <= 8); };
  for (std::size_t i = 0; i < frozen.size(); ++i) {
    if (may_grow(i)) {
      EXPECT_GE(facts[i], frozen[i]) << "fact " << i;
    } else {
      EXPECT_EQ(facts[i], frozen[i]) << "fact " << i;
    }
  }
}

}  // namespace
}  // namespace assay::test_abi_header
