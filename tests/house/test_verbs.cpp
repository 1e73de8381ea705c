// SPDX-License-Identifier: BSD-3-Clause
// A verb is a file of drivers/verbs, and nothing else lists it.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "tests/house/tree.hpp"

namespace assay::test_verbs {
namespace {

using namespace assay::house;

TEST(Verbs, AreTheFilesOfTheirFolder) {
  std::vector<std::string> files, known = verbs();
  for (const std::string& path : files_in("drivers/verbs", {".cpp"}, true)) {
    files.push_back(std::filesystem::path(path).stem().string());
    EXPECT_NE(text_of(path).find("\nVerb verb_" + files.back() + "() {\n"), std::string::npos) << path;
    std::replace(files.back().begin(), files.back().end(), '_', '-');
  }
  std::sort(files.begin(), files.end());
  std::sort(known.begin(), known.end());
  EXPECT_EQ(files, known);
  EXPECT_GE(files.size(), 12u);
}

TEST(Verbs, AreListedNowhereElse) {
  std::vector<std::string> sources = files_in("completions", {}, true);
  for (const char* path : {"drivers/command_line/command_line.cpp", "drivers/command_line/verb.hpp",
                           "drivers/command_line/verb.cpp", "cmake/verbs.cmake"})
    sources.emplace_back(path);
  for (const std::string& path : sources) {
    const std::string text = text_of(path);
    for (const std::string& verb : verbs()) {
      for (const char quote : {'"', '\''})
        EXPECT_EQ(text.find(quote + verb + quote), std::string::npos) << path << ": " << verb;
    }
  }
}

}  // namespace
}  // namespace assay::test_verbs
