// SPDX-License-Identifier: BSD-3-Clause
// A folder with sources, and a cache of the test's own.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/drivers/material/fortran_texts.hpp"
#include "tests/drivers/scratch_folder.hpp"

namespace assay::drivers {

/// Sets a variable of the environment as long as it lives.
class Environment {
 public:
  Environment(const char* name, const std::string& value) : name_(name) {
    const char* before = std::getenv(name);
    had_ = before != nullptr;
    before_ = had_ ? before : "";
    ::setenv(name, value.c_str(), 1);
  }
  ~Environment() { had_ ? ::setenv(name_, before_.c_str(), 1) : ::unsetenv(name_); }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  const char* name_;
  bool had_ = false;
  std::string before_;
};

class SourceTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_gfortran()) GTEST_SKIP() << "no gfortran";
  }
  /// Names of the files of the cache that end so, sorted.
  std::vector<std::string> kept(const std::string& ending) const {
    std::vector<std::string> names;
    std::error_code code;
    for (const auto& entry : std::filesystem::directory_iterator(scratch / "cache/sources", code)) {
      if (const std::string name = entry.path().filename().string(); name.ends_with(ending)) names.push_back(name);
    }
    std::sort(names.begin(), names.end());
    return names;
  }
  ScratchFolder scratch;
  Environment cache{"ASSAY_CACHE_HOME", scratch / "cache"};
};

}  // namespace assay::drivers
