// SPDX-License-Identifier: BSD-3-Clause
// Where this test program stands: the same objects are linked in several builds, so no path of one is compiled in.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

extern "C" void __asan_init() __attribute__((weak));

namespace assay {

/// The folder of the build that this program belongs to: test programs lie in it.
inline const std::string& built() {
  static const std::string folder = std::filesystem::read_symlink("/proc/self/exe").parent_path().string();
  return folder;
}

/// A file of that build.
inline std::string built(std::string_view path) { return built() + "/" + std::string(path); }

/// Whether the address sanitizer watches this program's libraries.
inline bool sanitized() { return __asan_init != nullptr; }

}  // namespace assay
