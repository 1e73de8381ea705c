// SPDX-License-Identifier: BSD-3-Clause
// `--set key.path=YAML value`.
#pragma once

#include <string>

#include "drivers/scene/yaml_reader.hpp"

namespace assay::drivers {

/// Puts the value at its place in the tree; a map replaces a map, missing maps are made. What follows `expect.` is one
/// key with its dots, and an operator after it. Throws InputError.
void apply_setting(Tree& root, const std::string& setting);

}  // namespace assay::drivers
