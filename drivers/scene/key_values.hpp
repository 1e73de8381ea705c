// SPDX-License-Identifier: BSD-3-Clause
// The value of a key as YAML has it: read strictly, and written so that it reads back to the bit.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "drivers/format/unit_rows.hpp"
#include "drivers/scene/scene_keys.hpp"

namespace assay::drivers {

/// Throws InputError at a key of the map that is not among `known`; says where it belongs if another map may have it.
/// `path` is that of the map, empty at the top.
void refuse_other_keys(const Tree& map, const std::string& path, const std::vector<std::string>& known);

/// In SI. `units`: those of the tree; `unit`: the SI unit of the key's numbers. Throws InputError at the value, or at
/// what is wrong inside a list.
Value read_value(const Key& key, const Tree& tree, const Units& units = {}, const std::string& unit = {});

/// Of what was read at a tree. Throws InputError there at what is no number in SI.
Value in_si(const Key& key, Value value, const Scale& scale, const Tree& tree);

/// Where a value stands, and in a list each item and each of its keys: by "motion.vortices[1].radius".
std::map<std::string, Location> places_of_value(const Key& key, const Tree& tree);

/// YAML. The items of a list have lines of their own, each after a line break.
std::string value_text(const Key& key, const Value& value);

/// What stands before a key of a section in a line of its own.
std::string indent_of_key(const std::string& path);

}  // namespace assay::drivers
