// SPDX-License-Identifier: BSD-3-Clause
// Values put over those of a scene: `--set key.path=YAML value`, and the axes of a study.
#pragma once

#include <string>

#include "drivers/format/yaml_reader.hpp"

namespace assay::drivers {

/// A value for the place of a scene at a dotted path.
struct Setting {
  std::string path;
  Tree value;
  Location where;  ///< of the path; the option where it came from the command line
};

/// Reads "key.path=YAML value". Throws InputError.
Setting parse_setting(const std::string& text);

/// Puts the value at its place in the tree; a map replaces a map, missing maps are made. What follows `expect.` is one
/// key with its dots, and an operator after it. Throws InputError.
void apply_setting(Tree& root, const Setting& setting);

/// Whether a step of a path numbers a value of a list: "0", "12", but not "01".
bool is_index(const std::string& step);

}  // namespace assay::drivers
