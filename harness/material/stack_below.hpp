// SPDX-License-Identifier: BSD-3-Clause
// What foreign code finds where it reads before it writes: local variables lie in the stack below its call, and what it
// allocates lies where something else was. Both are filled with known bytes right before the call, for what a model is
// told to be must not depend on what was there by chance.
#pragma once

#include <utility>

namespace assay {

/// The bytes with which calls of this thread find the stack and the heap; `left_alone`: as they are.
struct UnsetMemory {
  static constexpr int left_alone = -1;
  int stack = left_alone, heap = left_alone;
};
inline constinit thread_local UnsetMemory unset_memory{};

/// Doubles of such bytes are 0, 4.8e-4, -8.5e3 and no number.
inline constexpr unsigned char unset_bytes[] = {0x00, 0x3f, 0xc0, 0xff};

/// Sets a byte for as long as this lives, and then the one before again.
class OverMemory {
 public:
  OverMemory(const OverMemory&) = delete;
  OverMemory& operator=(const OverMemory&) = delete;

 protected:
  OverMemory(int& place, unsigned char byte) : place_(place), before_(std::exchange(place, byte)) {}
  ~OverMemory() { place_ = before_; }

 private:
  int& place_;
  int before_;
};

/// Fills the stack, and the vector registers, which hold local variables, too.
struct OverStack : OverMemory {
  explicit OverStack(unsigned char byte) : OverMemory(unset_memory.stack, byte) {}
};

/// Fills small blocks that are allocated next.
struct OverHeap : OverMemory {
  explicit OverHeap(unsigned char byte) : OverMemory(unset_memory.heap, byte) {}
};

void fill_stack_below(unsigned char byte);
void fill_free_blocks(unsigned char byte);

/// Right before foreign code is entered: nothing may come between that uses the stack. Inline even without
/// optimisation: a frame of its own would leave its words at the top.
[[gnu::always_inline]] inline void fill_unset_memory() {
  const UnsetMemory& bytes = unset_memory;
  if (bytes.heap != UnsetMemory::left_alone) fill_free_blocks(static_cast<unsigned char>(bytes.heap));
  if (bytes.stack != UnsetMemory::left_alone) fill_stack_below(static_cast<unsigned char>(bytes.stack));
}

}  // namespace assay
