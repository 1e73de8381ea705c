// SPDX-License-Identifier: BSD-3-Clause
// A scene between YAML and values: read strictly, changed by settings (`--set key.path=YAML value`, and the axes of a
// study), checked, and written with every key and default (resolved.yaml).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "drivers/format/yaml_reader.hpp"
#include "drivers/scene/scene.hpp"
#include "harness/numeric/interpolant.hpp"

namespace assay {
class DeformationTable;
}

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

/// Where a key of the scene stands.
using KeyPlace = std::function<Location(const std::string& key)>;

/// Throws InputError at the key that does not go with the others.
void check_scene(const Scene& scene, const KeyPlace& where);

/// `time`: the unit of t, unless the header says one. Columns t, F11, F12, F21, F22, perhaps F33, and F13, F23, F31,
/// F32, which only come together (0, and 1 for F33, where not given). Throws InputError as read_csv does, and unless
/// the first row is t = 0 with F = I, times ascend, and det F > 0 at all rows and at 32 times between two.
DeformationTable read_deformation_table(const std::string& file, Interpolation interpolation,
                                        const std::string& time = "s");

/// A value for the place of a scene at a path: `grid.spacing`, `motion.vortices[0].radius`.
struct Setting {
  std::string path;
  Tree value;
  Location where;  ///< of the path; the option where it came from the command line
};

/// A path with dots alone: `motion.vortices[0].radius` is `motion.vortices.0.radius`. Names that are the user's or of
/// the result stay as they are.
std::string dotted(const std::string& path);

/// Reads "key.path=YAML value". Throws InputError.
Setting parse_setting(const std::string& text);

/// Puts the value at its place in the tree; a map replaces a map, missing maps are made. What follows `expect.` is one
/// key with its dots, and an operator after it. Throws InputError.
void apply_setting(Tree& root, const Setting& setting);

/// Whether a step of a path numbers a value of a list: "0", "12", but not "01".
bool is_index(const std::string& step);

/// YAML text that reads back to the same scene; a function of the scene's values alone. Numbers are the shortest that
/// round-trip, paths are absolute.
std::string resolved_yaml(const Scene& scene);

}  // namespace assay::drivers
