// SPDX-License-Identifier: BSD-3-Clause
// Files that a model opens in the folder in which it works: `files` of a description.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "drivers/format/yaml_reader.hpp"
#include "drivers/material/material_description.hpp"

namespace assay::drivers {

/// A list of paths relative to `folder`, or a map from names to paths. A path that stays below the folder keeps it as
/// its name, another is known by its last part. Throws InputError: no such file, a name that leads out of a folder, two
/// of one name.
std::vector<ModelFile> read_model_files(const Tree& tree, const std::filesystem::path& folder);

/// Copies them to the folder in which this process stands: one of its own. What is there stays. Throws SystemError.
void place_model_files(const std::vector<ModelFile>& files);

}  // namespace assay::drivers
