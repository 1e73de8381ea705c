// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/system/input_bytes.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include "drivers/system/input_error.hpp"
#include "tests/drivers/scratch_folder.hpp"

namespace assay::drivers::test_input_bytes {
namespace {

TEST(InputBytes, ReadsAnyPieceOfAFileAgainAndAgain) {
  const ScratchFolder scratch;
  const InputBytes input(scratch.write("a", "0123456789"));
  EXPECT_EQ(input.size(), 10u);
  for (int k = 0; k < 2; ++k) {
    EXPECT_EQ(input.text(3, 4), "3456");
    EXPECT_EQ(input.text(0, 100), "0123456789");
    EXPECT_EQ(input.text(8, 100), "89");
    EXPECT_EQ(input.text(10, 1), "");
  }
}

TEST(InputBytes, KeepsAStream) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  ASSERT_EQ(::write(ends[1], "0123456789", 10), 10);
  ::close(ends[1]);
  const InputBytes input("/dev/fd/" + std::to_string(ends[0]));
  ::close(ends[0]);
  EXPECT_EQ(input.size(), 10u);
  for (int k = 0; k < 2; ++k) EXPECT_EQ(input.text(2, 5), "23456");
}

TEST(InputBytes, RefusesAFileThatChanges) {
  const ScratchFolder scratch;
  const InputBytes input(scratch.write("a", "0123456789"));
  scratch.write("a", "01234567890");
  EXPECT_THROW(input.text(0, 1), InputError);
  std::filesystem::remove(input.file());
  EXPECT_THROW(input.text(0, 1), InputError);
}

TEST(InputBytes, RefusesWhatIsNoFile) {
  const ScratchFolder scratch;
  EXPECT_THROW(InputBytes(scratch / "missing"), InputError);
  EXPECT_THROW(InputBytes(scratch / "."), InputError);
  EXPECT_THROW(InputBytes(""), InputError);
}

TEST(InputBytes, AnUnnamedFileGrowsAndLeavesNothing) {
  const ScratchFolder scratch;
  const char* before = std::getenv("TMPDIR");
  const std::string kept = before ? before : "";
  ::setenv("TMPDIR", (scratch / "").c_str(), 1);
  {
    UnnamedFile file;
    file.append("ab");
    file.write_at(4, "ef");
    file.write_at(2, "cd");
    EXPECT_EQ(file.size(), 6u);
    char bytes[8];
    EXPECT_EQ(read_at(file.number(), 1, bytes, sizeof bytes), 5);
    EXPECT_EQ(std::string(bytes, 5), "bcdef");
    EXPECT_TRUE(std::filesystem::is_empty(scratch / ""));
  }
  ::setenv("TMPDIR", (scratch / "missing").c_str(), 1);
  EXPECT_THROW(UnnamedFile(), SystemError);
  before ? ::setenv("TMPDIR", kept.c_str(), 1) : ::unsetenv("TMPDIR");
}

}  // namespace
}  // namespace assay::drivers::test_input_bytes
