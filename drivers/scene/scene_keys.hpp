// SPDX-License-Identifier: BSD-3-Clause
// The one table of scene keys: the reader, resolved.yaml and the JSON Schema are all made from it.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <variant>
#include <vector>

#include "drivers/format/yaml_values.hpp"
#include "drivers/scene/scene.hpp"

namespace assay::drivers {

/// monostate: absent.
using Value = std::variant<std::monostate, bool, double, std::string, std::vector<double>>;

/// automatic: a number, or the word "auto", which is what stands where nothing is given.
enum class KeyType { number, automatic, boolean, text, choice, pair, vector, matrix };

/// What is to say of a key beside its value.
struct KeyRules {
  Range range = {};                       ///< of a number, or of each in a pair or matrix
  std::vector<std::string> choices = {};  ///< of words; of an enumeration's names empty: all
  bool required = false;
  std::string derived = {};               ///< how the default follows from other keys; empty: it is a constant
  std::vector<std::string> motions = {};  ///< motion.type for which the key exists; empty: all
  std::vector<std::string> domains = {};  ///< likewise body.domain
  bool (*shown)(const Scene&) = nullptr;  ///< whether resolved.yaml has it; null: where it has a value
};

struct Key : KeyRules {
  std::string path;  ///< "motion.amplitude.peak"
  KeyType type = KeyType::number;
  std::string doc;  ///< one line, with the unit
  std::function<Value(const Scene&)> get;
  std::function<void(Scene&, const Value&)> set;
};

struct Section {
  std::string path;
  std::string doc;
  bool required = false;
  bool optional_part = false;       ///< absent from the scene unless written (grid, method)
  void (*begin)(Scene&) = nullptr;  ///< makes room in the scene for the section
  bool free_keys = false;           ///< keys are names of the user's or of the result's: no table
};

/// In the order in which they are read and written; a section before its keys.
const std::vector<Section>& scene_sections();
const std::vector<Key>& scene_keys();

/// Names that may stand directly under a section ("" is the top), for the scene's motion and domain or for all.
std::vector<std::string> names_under(const std::string& section, const Scene* scene = nullptr);

/// Whether the key exists for this scene's motion, on some domain.
bool of_motion(const Key& key, const Scene& scene);
/// Whether the key exists for this scene's motion and domain.
bool applies(const Key& key, const Scene& scene);
/// Whether any of its keys does.
bool applies(const Section& section, const Scene& scene);

std::string motion_type(const Scene& scene);
std::string domain_name(Body::Domain domain);

/// The part that says what moves and how: title, motion.* and frame.*.
std::vector<Key> motion_keys();

/// The words of motion.type of all motions for which something holds.
std::vector<std::string> types_of(const std::function<bool(const Motion&)>& holds);

// `assay schema`: scenes as JSON Schema (draft 2020-12), and what the schema of studies shares with it.

/// Indented JSON with a newline at the end.
std::string schema_json();

/// Of keys that every map may have: those that are merged into it, as YAML has it.
inline constexpr const char *merge_name = "<<", *merge_pattern = "^<<$";
/// Of keys of the whole that hold anchors.
inline constexpr const char* anchors_pattern = "^x-";

/// What names a schema to an editor, "urn:assay:schema:scene:1.0.0": the same on every machine.
std::string schema_id(const std::string& what);

/// The values of a key of a scene.
nlohmann::ordered_json type_schema(const Key& key);

/// What is said of a figure of result.json, and what may be expected of it; `outcomes` are those that there may be.
nlohmann::ordered_json expectation_schema(const std::string& key, const std::vector<std::string>& outcomes);

}  // namespace assay::drivers
