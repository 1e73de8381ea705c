// SPDX-License-Identifier: BSD-3-Clause
#include "harness/material/stack_below.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <memory>

namespace assay {

namespace {

constexpr std::size_t stack_reach = 48 << 10;  ///< [bytes], beyond the arrays of `Material::update` and of bridges

}  // namespace

// The address sanitizer keeps arrays on a stack of its own, and watches memset(): what is filled is the real stack, by
// instructions of its own.
#if defined(__x86_64__)
// Below the stack pointer itself, so that no word of this function's frame is left at the top: no local variable is
// used once that is done.
__attribute__((noinline, no_sanitize("address"))) void fill_stack_below(unsigned char byte) {
  const std::uint64_t word = 0x0101010101010101U * std::uint64_t{byte};
  std::uint64_t count = stack_reach / sizeof word;
  void* at;
  __asm__ volatile(
      "leaq -%c[reach](%%rsp), %%rdi\n\t"
      "rep stosq\n\t"
      "movq %%rax, %%xmm0\n\t"
      "punpcklqdq %%xmm0, %%xmm0\n\t"
      "movaps %%xmm0, %%xmm1\n\t"
      "movaps %%xmm0, %%xmm2\n\t"
      "movaps %%xmm0, %%xmm3\n\t"
      "movaps %%xmm0, %%xmm4\n\t"
      "movaps %%xmm0, %%xmm5\n\t"
      "movaps %%xmm0, %%xmm6\n\t"
      "movaps %%xmm0, %%xmm7\n\t"
      "movaps %%xmm0, %%xmm8\n\t"
      "movaps %%xmm0, %%xmm9\n\t"
      "movaps %%xmm0, %%xmm10\n\t"
      "movaps %%xmm0, %%xmm11\n\t"
      "movaps %%xmm0, %%xmm12\n\t"
      "movaps %%xmm0, %%xmm13\n\t"
      "movaps %%xmm0, %%xmm14\n\t"
      "movaps %%xmm0, %%xmm15"
      : "=&D"(at), "+c"(count)
      : "a"(word), [reach] "i"(stack_reach)
      : "memory", "cc", "xmm0", "xmm1", "xmm2", "xmm3", "xmm4", "xmm5", "xmm6", "xmm7", "xmm8", "xmm9", "xmm10",
        "xmm11", "xmm12", "xmm13", "xmm14", "xmm15");
}
#else
__attribute__((noinline, no_sanitize("address"))) void fill_stack_below(unsigned char byte) {
  const std::uint64_t word = 0x0101010101010101U * std::uint64_t{byte};
  auto* room = static_cast<volatile std::uint64_t*>(__builtin_alloca(stack_reach));
  for (std::size_t k = 0; k < stack_reach / sizeof word; ++k) room[k] = word;
  __asm__ volatile("" : : "r"(room) : "memory");
}
#endif

// The C library keeps up to seven freed blocks of each small size, and hands out the last of them first. It writes
// 16 bytes at the beginning of each, which stay its own.
void fill_free_blocks(unsigned char byte) {
  constexpr std::size_t smallest = 24, largest = 1032, apart = 16, kept = 7;  // [bytes], and how many of a size
  constexpr std::size_t beyond[] = {2048, 6400};
  std::array<std::unique_ptr<unsigned char[]>, kept*((largest - smallest) / apart + 1) + std::size(beyond)> blocks;
  auto next = blocks.begin();
  const auto fill = [&](std::size_t size) {
    *next = std::make_unique_for_overwrite<unsigned char[]>(size);
    std::memset(next->get(), byte, size);
    __asm__ volatile("" : : "r"(next->get()) : "memory");
    ++next;
  };
  for (std::size_t size = smallest; size <= largest; size += apart) {
    for (std::size_t k = 0; k < kept; ++k) fill(size);
  }
  for (const std::size_t size : beyond) fill(size);
}

}  // namespace assay
