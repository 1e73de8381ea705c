// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/house/tree.hpp"

namespace assay::test_licence {
namespace {

using namespace assay::house;

const std::string licence = "SPDX-License-Identifier: BSD-3-Clause";

/// The licence stands on the first line, or the second after a `#!` or zsh's `#compdef`.
bool carries_licence(const std::string& text) {
  const auto lines = lines_of(text);
  if (lines.empty()) return false;
  const bool second = lines[0].rfind("#!", 0) == 0 || lines[0].rfind("#compdef", 0) == 0;
  const std::size_t at = second ? 1 : 0;
  return at < lines.size() && lines[at].find(licence) != std::string::npos;
}

TEST(Licence, EverySourceFileNamesIt) {
  std::vector<std::string> files{"CMakeLists.txt",    "dev",
                                 ".ci/run",           ".ci/changed.py",
                                 ".ci/each_alone.py", ".ci/plant.py",
                                 ".ci/two_clones.sh", ".clang-tidy",
                                 "docs/assay.1",      "cmake/package/Dockerfile"};
  for (const char* folder : {"harness", "adapters", "mpm", "drivers", "tests", "bench", "cmake"}) {
    for (auto& path :
         files_in(folder,
                  {".hpp", ".cpp", ".h", ".c", ".f90", ".F90", ".cmake", ".in", ".map", ".txt", ".py", ".sh", ".def"},
                  true)) {
      files.push_back(path);
    }
  }
  for (auto& path : files_in("completions", {}, true)) files.push_back(path);
  EXPECT_GT(files.size(), 40u);
  for (const std::string& path : files) EXPECT_TRUE(carries_licence(text_of(path))) << path;
}

TEST(Licence, MissingOrMisplacedIsCaught) {
  EXPECT_FALSE(carries_licence(""));
  EXPECT_FALSE(carries_licence("#pragma once\n// " + licence + "\n"));
  EXPECT_TRUE(carries_licence("#!/bin/sh\n# " + licence + "\n"));
}

// What the build links is named, with its licence, in THIRD_PARTY.md.
TEST(Licence, EveryDependencyIsListed) {
  const std::string listed = text_of("THIRD_PARTY.md");
  const std::string build = text_of("CMakeLists.txt");
  for (const char* name : {"Eigen", "Boost", "yaml-cpp", "CLI11", "fmt", "muparser", "nlohmann", "stb"}) {
    EXPECT_NE(build.find(name), std::string::npos) << name << " is no longer used: drop it here and in THIRD_PARTY.md";
    EXPECT_NE(listed.find(name), std::string::npos) << name;
  }
}

}  // namespace
}  // namespace assay::test_licence
