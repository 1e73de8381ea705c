// SPDX-License-Identifier: BSD-3-Clause
// A registry of the test's own, and the test plug-ins.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/support/built.hpp"

namespace assay::drivers {

inline const std::string plugins = built("tests/plugins/");

/// An empty folder for each test; ASSAY_DATA_HOME lies in it and $ASSAY_MATERIAL_PATH is unset.
class RegistryTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder = std::filesystem::path(testing::TempDir()) / (std::string(info->test_suite_name()) + "_" + info->name());
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    setenv("ASSAY_DATA_HOME", (folder / "data").c_str(), 1);
    unsetenv("ASSAY_MATERIAL_PATH");
  }
  void TearDown() override {
    std::filesystem::remove_all(folder);
    unsetenv("ASSAY_DATA_HOME");
    unsetenv("ASSAY_MATERIAL_PATH");
  }
  /// Writes a file under the test's folder and returns its path.
  std::string write(const std::string& name, const std::string& text) const {
    const std::filesystem::path path = folder / name;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path) << text;
    return path.string();
  }
  std::string read(const std::string& name) const {
    std::ifstream file(folder / name);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  std::filesystem::path folder;
};

}  // namespace assay::drivers
