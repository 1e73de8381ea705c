// SPDX-License-Identifier: BSD-3-Clause
// `assay schema`: scenes as JSON Schema (draft 2020-12), made from the reader's table of keys; and what the schema of
// studies shares with it, as JSON text.
#pragma once

#include <string>
#include <vector>

#include "drivers/scene/scene_keys.hpp"

namespace assay::drivers {

/// Indented JSON with a newline at the end.
std::string schema_json();

/// Of keys that every map may have: those that are merged into it, as YAML has it.
inline constexpr const char *merge_name = "<<", *merge_pattern = "^<<$";
/// Of keys of the whole that hold anchors.
inline constexpr const char* anchors_pattern = "^x-";

/// What names a schema to an editor, "urn:assay:schema:scene:1.0.0": the same on every machine.
std::string schema_id(const std::string& what);

/// The values of a key of a scene.
std::string type_schema(const Key& key);

/// What may be expected of a figure of result.json; `outcomes` are those that there may be.
std::string expectation_schema(const std::string& key, const std::vector<std::string>& outcomes);

}  // namespace assay::drivers
