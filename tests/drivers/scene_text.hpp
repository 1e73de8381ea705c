// SPDX-License-Identifier: BSD-3-Clause
// Scenes for the tests of the reader.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/tree_folder.hpp"

namespace assay::drivers {

/// A complete scene in few lines; `extra` is appended.
inline std::string scene_text(const std::string& extra = {}) {
  return "motion: {type: vortex}\n"
         "material: {adapter: neo_hookean, parameters: {E: 1e3}, density: 1000}\n" +
         extra;
}

/// A scene of the other motion.
inline std::string homogeneous_text(const std::string& extra = {}) {
  return "motion: {type: homogeneous, final: [[1.2, .1, 0], [0, .9, 0], [0, 0, 1]]}\n"
         "material: {adapter: neo_hookean, parameters: {E: 1e3}, density: 1000}\n" +
         extra;
}

/// Every scene under configs/; studies are none.
inline std::vector<std::string> all_configs() {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(tree_folder() + "/configs")) {
    const std::string extension = entry.path().extension().string();
    const std::string folder = entry.path().parent_path().filename().string();
    if (folder == "studies" || folder == "paths") continue;  // no scenes
    if (extension == ".yaml" || extension == ".yml") files.push_back(entry.path().string());
  }
  return files;
}

}  // namespace assay::drivers
