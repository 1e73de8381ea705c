// SPDX-License-Identifier: BSD-3-Clause
// YAML that the program has written in a test is kept in the build folder, where tests/yaml/check_yaml.py reads it.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>

#include "tests/support/built.hpp"

namespace assay {

/// Keeps a text as KIND.HASH.EXTENSION. The kind says what the script asks of it: `scene` and `path` are to satisfy
/// their schemas, `plain` is to be the same to every reader, `values` is to hold what the JSON file of the same hash
/// holds.
inline void keep_yaml(const std::string& kind, const std::string& text, const std::string& json = {}) {
  const std::string hash = std::to_string(std::hash<std::string>{}(text)), name = kind + "." + hash;
  const std::string folder = built("yaml_of_tests");
  std::filesystem::create_directories(folder);
  const auto write = [&](const std::string& extension, const std::string& bytes) {
    static int count = 0;  // another process may write the same file
    const std::string part = folder + "/part." + std::to_string(::getpid()) + "." + std::to_string(count++);
    std::ofstream(part, std::ios::binary) << bytes;
    std::filesystem::rename(part, folder + "/" + name + extension);
  };
  if (!json.empty()) write(".json", json);
  write(".yaml", text);
}

/// Keeps the resolved scenes of every result below a folder. What a test planted has no result.json beside it.
inline void keep_resolved_scenes(const std::filesystem::path& folder) {
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const auto name = entry.path().filename();
    if (name != "resolved.yaml" && name != "replay_scene.yaml") continue;
    if (!std::filesystem::exists(entry.path().parent_path() / "result.json")) continue;
    std::ifstream in(entry.path(), std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    const bool path = text.find("\npath:") != text.npos || text.find("\nstages:") != text.npos;
    keep_yaml(path ? "path" : "scene", text);
  }
}

}  // namespace assay
