// SPDX-License-Identifier: BSD-3-Clause
// The sources of a folder are compiled together: each test file has a namespace of its own, called like the file.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>

#include "tests/house/tree.hpp"

namespace assay::test_namespaces {
namespace {

using namespace assay::house;

bool has_its_own(const std::string& path, const std::string& text) {
  const std::string stem = std::filesystem::path(path).stem().string();
  return std::regex_search(text, std::regex("(^|\n)namespace assay(::\\w+)*::" + stem + " \\{\n"));
}

TEST(Namespaces, EachTestFileHasItsOwn) {
  int seen = 0;
  for (const std::string& path : files_in("tests", {".cpp"}, true)) {
    if (!std::filesystem::path(path).filename().string().starts_with("test_")) continue;
    EXPECT_TRUE(has_its_own(path, text_of(path))) << path;
    ++seen;
  }
  EXPECT_GT(seen, 200);
}

TEST(Namespaces, OnesOfAnotherNameAreCaught) {
  EXPECT_TRUE(has_its_own("tests/mpm/step/test_sweep.cpp", "namespace assay::mpm::test_sweep {\n"));
  EXPECT_FALSE(has_its_own("tests/mpm/step/test_sweep.cpp", "namespace assay::mpm {\n"));
  EXPECT_FALSE(has_its_own("tests/mpm/step/test_sweep.cpp", "namespace assay::mpm::test_blocks {\n"));
}

}  // namespace
}  // namespace assay::test_namespaces
