// SPDX-License-Identifier: BSD-3-Clause
// What a function finds in the memory that it has not set.
#include "harness/material/stack_below.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <thread>

#include "harness/material/thrown.hpp"
#include "tests/support/built.hpp"

namespace assay::test_stack_below {
namespace {

constexpr std::size_t room_size = 32 << 10;  // [bytes]

/// How many bytes of a variable that is not set are these.
__attribute__((noinline, no_sanitize("address"))) std::size_t unset_bytes_that_are(unsigned char byte) {
  unsigned char room[room_size];
  const unsigned char* at = room;
  __asm__ volatile("" : "+r"(at) : : "memory");  // who knows what it points to now
  std::size_t count = 0;
  for (std::size_t k = 0; k < room_size; ++k) count += at[k] == byte ? 1 : 0;
  return count;
}

[[gnu::noinline]] std::size_t found_of(unsigned char byte) {
  fill_unset_memory();
  return unset_bytes_that_are(byte);
}

TEST(StackBelow, IsOfTheByteThatWasAskedForLast) {
  for (const unsigned char byte : unset_bytes) {
    const OverStack over(byte);
    EXPECT_EQ(found_of(byte), room_size) << int{byte};
  }
  const OverStack outer(0x3f);
  {
    const OverStack inner(0xc0);
    EXPECT_EQ(found_of(0xc0), room_size);
  }
  EXPECT_EQ(found_of(0x3f), room_size);
}

TEST(StackBelow, IsLeftAloneWhereNobodyAsks) {
  const auto left = [] {
    {
      const OverStack over(0x11);
      fill_unset_memory();
    }
    fill_unset_memory();
    return unset_bytes_that_are(0x11);
  };
  EXPECT_GT(left(), room_size / 2);
}

TEST(StackBelow, IsOfTheThreadThatAsks) {
  const OverStack over(0xc0);
  int other = 0;
  std::thread([&] { other = unset_memory.stack; }).join();
  EXPECT_EQ(other, UnsetMemory::left_alone);
}

TEST(StackBelow, IsFilledForEachCallOfATable) {
  const OverStack over(0xc0);
  std::size_t found = 0;
  EXPECT_EQ(thrown_by(&unset_bytes_that_are, [&] { found = unset_bytes_that_are(0xc0); }), "");
  EXPECT_EQ(found, room_size);
}

#if defined(__x86_64__)
TEST(StackBelow, IsInTheVectorRegistersToo) {
  const OverStack over(0x3f);
  std::uint64_t first = 0, last = 0;
  fill_unset_memory();
  __asm__ volatile("movq %%xmm0, %0\n\tmovq %%xmm15, %1" : "=r"(first), "=r"(last));
  EXPECT_EQ(first, 0x3f3f3f3f3f3f3f3fU);
  EXPECT_EQ(last, 0x3f3f3f3f3f3f3f3fU);
}
#endif

TEST(HeapOfCalls, IsOfTheByteThatWasAskedFor) {
  if (sanitized()) GTEST_SKIP() << "the address sanitizer fills what is allocated";
  constexpr std::size_t of_library = 16;  // bytes at the beginning of a block that was free
  static void* (*volatile const allocate)(std::size_t) = std::malloc;
  for (const std::size_t size : {24, 48, 72, 288, 328, 1000}) {
    const OverHeap over(0x3f);
    fill_unset_memory();
    auto* const block = static_cast<unsigned char*>(allocate(size));
    EXPECT_EQ(std::count(block + of_library, block + size, 0x3f), static_cast<std::ptrdiff_t>(size - of_library))
        << size;
    std::free(block);
  }
}

}  // namespace
}  // namespace assay::test_stack_below
