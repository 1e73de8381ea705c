// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/system/environment.hpp"

#include <gtest/gtest.h>

#include "tests/drivers/material/source_fixture.hpp"

namespace assay::drivers::test_cache_home {
namespace {

std::string found(const char* own, const char* xdg, const char* home) {
  const Environment first("ASSAY_CACHE_HOME", own), second("XDG_CACHE_HOME", xdg), third("HOME", home);
  return cache_home();
}

TEST(CacheHome, IsTheFirstThatIsSaid) {
  EXPECT_EQ(found("/a", "/b", "/c"), "/a");
  EXPECT_EQ(found("", "/b", "/c"), "/b/assay");
  EXPECT_EQ(found("", "", "/c"), "/c/.cache/assay");
  EXPECT_EQ(found("", "", ""), "");
}

TEST(CacheHome, IgnoresRelativePathsAsTheStandardOfXdgAsks) {
  EXPECT_EQ(found("", "b", "/c"), "/c/.cache/assay");
  EXPECT_EQ(found("", "./b", "c"), "");
  EXPECT_EQ(found("", "", "../c"), "");
}

}  // namespace
}  // namespace assay::drivers::test_cache_home
