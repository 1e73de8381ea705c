// SPDX-License-Identifier: BSD-3-Clause
// `assay tabulate` of a path.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "drivers/findings/run_options.hpp"
#include "drivers/format/yaml_reader.hpp"

namespace assay::drivers {

/// Whether the text of a scene is that of a path. Throws InputError where it is no YAML.
bool is_path_text(std::string_view text, const std::string& file);

/// Its values, changed by settings. Throws InputError.
Tree path_tree(std::string_view text, const std::string& file, const std::vector<std::string>& sets);

/// Takes the material and its variants along the path, and leaves tables, pictures and result.json in the folder.
/// Returns the exit status. Throws InputError.
int tabulate_path(const Tree& root, const std::string& sha256, const SceneOptions& options);

}  // namespace assay::drivers
