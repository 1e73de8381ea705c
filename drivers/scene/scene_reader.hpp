// SPDX-License-Identifier: BSD-3-Clause
// The strict scene reader.
#pragma once

#include <string>
#include <vector>

#include "drivers/format/yaml_reader.hpp"
#include "drivers/scene/scene.hpp"
#include "harness/numeric/interpolant.hpp"

namespace assay::drivers {

/// What a verb does with a table of F between its rows where the scene does not say: a body force needs F''.
inline constexpr Interpolation to_run = Interpolation::monotone, to_tabulate = Interpolation::linear;

/// The scene in a YAML file, changed by `key.path=YAML value` settings before it is checked. Relative paths become
/// absolute: from the file's folder, in settings from the working directory. Throws InputError.
Scene read_scene(const std::string& file, const std::vector<std::string>& sets = {}, Interpolation otherwise = to_run);

/// The values of a scene's text, a map. Throws InputError.
Tree scene_tree(std::string_view text, const std::string& file);

/// The scene that the values are; relative paths count from the folder of the file in which they stand. Throws
/// InputError.
Scene scene_of(const Tree& root, const std::string& file, const std::string& sha256, Interpolation otherwise = to_run);

/// The same of a text; `file` is its name, `sha256` of its bytes.
Scene scene_from_text(std::string_view text, const std::string& file, const std::vector<std::string>& sets = {},
                      Interpolation otherwise = to_run);

}  // namespace assay::drivers
