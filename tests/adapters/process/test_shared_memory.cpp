// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/process/private_files.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

namespace assay::adapters::test_shared_memory {
namespace {

/// Whoever shares it could end the other side by SIGBUS.
TEST(SharedMemory, KeepsItsSize) {
  constexpr std::size_t bytes = 1 << 16;
  const SharedMemory memory(bytes);
  EXPECT_EQ(::ftruncate(memory.file(), 0), -1);
  EXPECT_EQ(::ftruncate(memory.file(), 2 * bytes), -1);
  static_cast<char*>(memory.data())[bytes - 1] = 1;
}

}  // namespace
}  // namespace assay::adapters::test_shared_memory
