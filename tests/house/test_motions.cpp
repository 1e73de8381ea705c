// SPDX-License-Identifier: BSD-3-Clause
// A motion is a file of harness/motion/kinds and listed nowhere else: the rest of the program finds it by itself.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "harness/motion/registry.hpp"
#include "tests/house/tree.hpp"

namespace assay::test_motions {
namespace {

using namespace assay::house;

std::set<std::string> words() {
  std::set<std::string> all;
  for (const Motion& sample : motion_registry().samples()) all.emplace(sample->type());
  return all;
}

TEST(Motions, TheirWordsStandInTheirFilesAlone) {
  const std::set<std::string> may_name{
      "drivers/scene/motion_keys.cpp \"homogeneous\"",  // motion.path, whose file is read with the scene
      "drivers/check/check_material.hpp \"vortex\"",    // a test of check
      "drivers/verbs/new_material.cpp \"vortex\"",      // a file
      "drivers/scene/body.hpp \"vortex\"",              // the body of one, a word of body.domain
      "harness/motion/path.hpp \"rotating_stretch\"",   // names of paths
      "drivers/path/path_reader.cpp \"rigid\"",         // a scene by which the keys of a material are read
  };
  for (const char* floor : {"harness", "adapters", "mpm", "drivers"}) {
    for (const std::string& path : files_in(floor, {".hpp", ".cpp"}, true)) {
      if (path.starts_with("harness/motion/kinds/")) continue;
      const std::string text = text_of(path);
      for (const std::string& word : words()) {
        const std::string quoted = "\"" + word + "\"";
        if (text.find(quoted) == text.npos) continue;
        EXPECT_TRUE(may_name.contains(path + " " + quoted)) << path << " names the motion " << quoted;
      }
    }
  }
}

TEST(Motions, EveryFileRegistersSomething) {
  std::size_t files = 0;
  for (const std::string& path : files_in("harness/motion/kinds", {".cpp"}, false)) {
    ++files;
    const std::string name = std::filesystem::path(path).stem();
    EXPECT_NE(text_of(path).find("void register_" + name + "(MotionRegistry& registry)"), std::string::npos) << path;
  }
  EXPECT_GE(files, 7U);
  EXPECT_GE(words().size(), 7U);
}

class EveryMotion : public testing::TestWithParam<std::string> {};

/// Takes what it is shown, and keeps the names.
class Names final : public Keys {
 public:
  std::set<std::string> names;

 protected:
  std::optional<KeyValue> meet(const KeyInfo& key, KeyType, const KeyValue&) override {
    EXPECT_NE(key.doc, "") << key.name;
    EXPECT_TRUE(names.insert(std::string(key.name)).second) << key.name << " twice";
    return std::nullopt;
  }
};

TEST_P(EveryMotion, HasKeysAnExampleInTheTreeAndAPlaceInThePages) {
  for (Motion sample : motion_registry().samples()) {
    if (sample->type() != GetParam()) continue;
    Names names;
    sample->keys(names);
    EXPECT_FALSE(names.names.empty());
  }
  const std::string line = "type: " + GetParam();
  bool is_run = false;
  for (const char* folder : {"configs", "tests"}) {
    for (const std::string& path : files_in(folder, {".yaml"}, true))
      is_run |= text_of(path).find(line) != std::string::npos;
  }
  EXPECT_TRUE(is_run) << "no scene of configs or tests has " << line;
  EXPECT_NE(text_of("docs/motions.md").find("`" + GetParam() + "`"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Registered, EveryMotion, testing::ValuesIn([] {
                           const std::set<std::string> all = words();
                           return std::vector<std::string>(all.begin(), all.end());
                         }()),
                         [](const auto& c) { return c.param; });

}  // namespace
}  // namespace assay::test_motions
