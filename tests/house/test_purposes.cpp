// SPDX-License-Identifier: BSD-3-Clause
// Whoever opens a source reads in its first lines what it is for, or in those of its own header.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/house/tree.hpp"
#include "tests/support/tree_folder.hpp"

namespace assay::test_purposes {
namespace {

/// Behind the licence.
bool says_its_purpose(const std::string& text) {
  const std::vector<std::string> lines = house::lines_of(text);
  return lines.size() > 1 && lines[1].starts_with("// ");
}

TEST(Purposes, EachSourceSaysWhatItIsFor) {
  int seen = 0;
  for (const char* floor : {"harness", "adapters", "mpm", "drivers"}) {
    for (const std::string& path : house::files_in(floor, {".cpp"}, true)) {
      if (path.starts_with("mpm/effects/")) continue;  // the record says it, and `assay explain` shows it
      const std::string header = std::filesystem::path(path).replace_extension(".hpp");
      const bool has_header = std::filesystem::exists(std::filesystem::path(tree_folder()) / header);
      EXPECT_TRUE(says_its_purpose(house::text_of(path)) || (has_header && says_its_purpose(house::text_of(header))))
          << path;
      ++seen;
    }
  }
  EXPECT_GT(seen, 250);
}

TEST(Purposes, OneThatSaysNothingIsCaught) {
  EXPECT_TRUE(says_its_purpose("// SPDX-License-Identifier: BSD-3-Clause\n// What it is for.\n#include <cmath>\n"));
  EXPECT_FALSE(says_its_purpose("// SPDX-License-Identifier: BSD-3-Clause\n#include <cmath>\n// A function.\n"));
}

}  // namespace
}  // namespace assay::test_purposes
