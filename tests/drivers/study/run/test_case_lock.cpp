// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/study/run/case_store.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "drivers/system/input_error.hpp"
#include "tests/drivers/scratch_folder.hpp"

namespace assay::drivers::test_case_lock {
namespace {

namespace fs = std::filesystem;

TEST(CaseLock, IsHeldByOne) {
  const ScratchFolder scratch;
  const auto lock = CaseLock::tried(scratch / "case");
  EXPECT_TRUE(lock);
  EXPECT_FALSE(CaseLock::tried(scratch / "case"));
}

/// Nothing is left where a link leads.
TEST(CaseLock, DoesNotFollowALink) {
  const ScratchFolder scratch;
  fs::create_directories(fs::path(scratch / "elsewhere"));
  fs::create_directory_symlink(scratch / "elsewhere", scratch / "case");
  fs::create_directory_symlink(scratch / "absent", scratch / "dangling");
  EXPECT_THROW(CaseLock::tried(scratch / "case"), SystemError);
  EXPECT_THROW(CaseLock::tried(scratch / "dangling"), SystemError);
  EXPECT_TRUE(fs::is_empty(scratch / "elsewhere"));
  EXPECT_FALSE(fs::exists(scratch / "absent"));
}

}  // namespace
}  // namespace assay::drivers::test_case_lock
