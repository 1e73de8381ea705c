// SPDX-License-Identifier: BSD-3-Clause
// The one table of scene keys: the reader, resolved.yaml and the JSON Schema are all made from it.
#pragma once

#include <functional>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "drivers/format/yaml_values.hpp"
#include "drivers/scene/scene.hpp"
#include "harness/numeric/keys.hpp"

namespace assay::drivers {

using assay::KeyType;
using Value = KeyValue;

/// One row of the table of keys. A struct of the scene says what stands in it (KeyRules).
struct Key {
  std::string path;  ///< "motion.amplitude.peak"
  KeyType type = KeyType::number;
  std::string doc;                                         ///< one line
  std::string unit = {};                                   ///< in SI; empty: the number has none
  std::map<std::string, std::string> unit_of_motion = {};  ///< of motions for which it is another, by their words
  Range range = {};                                        ///< of a number, or of each in a list
  std::vector<std::string> choices = {};                   ///< of words
  bool required = false;
  std::string derived = {};                   ///< how the default follows from other keys; empty: it is a constant
  std::vector<std::string> motions, domains;  ///< words of motion.type and body.domain for which it exists; empty: all
  bool all_motions_in_space = false;          ///< where the dimension is 3 it exists for all
  std::function<Value(const Scene&)> get;     ///< absent: nothing to be written
  std::function<void(Scene&, const Value&)> set;
  std::vector<Key> items = {};  ///< of a list: the keys of an item. path: the name alone; get: the default; set: none
};

struct Section {
  std::string path;
  std::string doc;
  bool required = false;
  bool free_keys = false;  ///< keys are names of the user's or of the result's: no table
  std::vector<Key> keys = {};
  std::function<void(Scene&)> begin = {};  ///< where it is absent unless written (grid, method): makes room for it
};

/// In the order in which they are read and written; a section before its keys.
const std::vector<Section>& scene_sections();
const std::vector<Key>& scene_keys();

/// Names that may stand directly under a section ("" is the top), for the scene's motion and domain or for all.
std::vector<std::string> names_under(const std::string& section, const Scene* scene = nullptr);

/// Names that an item of the list may have; none where the key is no list.
std::vector<std::string> item_names(const Key& list);

/// The SI unit of the key's numbers for this scene's motion; "1" where they have none.
std::string unit_of(const Key& key, const Scene& scene);
/// The doc with the unit behind what it is of: "node spacing h [m]; nodes are at multiples of h".
std::string doc_of(const Key& key);

/// Whether the key exists for this scene's motion, on some domain.
bool of_motion(const Key& key, const Scene& scene);
/// Whether the key exists for this scene's motion and domain.
bool applies(const Key& key, const Scene& scene);
/// Whether any of its keys does.
bool applies(const Section& section, const Scene& scene);

std::string motion_type(const Scene& scene);
std::string domain_name(Body::Domain domain);

using Get = std::function<Value(const Scene&)>;
using Set = std::function<void(Scene&, const Value&)>;

/// Makes a row. `get` and `set` reach the value in a scene.
Key key_row(const std::string& path, std::string_view doc, KeyType type, const KeyRules& rules, Get get, Set set);
/// The rows of an item's keys; none where the key is no list.
std::vector<Key> item_rows(const KeyInfo& list);

// A part of a scene shows its keys.
void show(auto& part, Keys& visitor) { part.keys(visitor); }
inline void show(Motion& motion, Keys& visitor) { motion->keys(visitor); }
void show(mpm::EffectOptions& options, Keys& visitor);
template <class Part>
void show(std::optional<Part>& part, Keys& visitor) {
  if (part) part->keys(visitor);
}

/// A row for each key that `sample` shows. look, change: show those of a scene.
std::vector<Key> rows_of_part(const std::string& section, const std::function<void(Keys&)>& sample,
                              const std::function<void(const Scene&, Keys&)>& look,
                              const std::function<void(Scene&, Keys&)>& change);

/// The same; std::invoke(part, scene) leads to the part of a scene that `sample` is one of.
std::vector<Key> keys_of(const std::string& section, auto sample, auto part) {
  const auto look = [part](const Scene& scene, Keys& visitor) {
    auto copy = std::invoke(part, scene);
    show(copy, visitor);
  };
  const auto change = [part](Scene& scene, Keys& visitor) { show(std::invoke(part, scene), visitor); };
  return rows_of_part(
      section, [&](Keys& visitor) { show(sample, visitor); }, look, change);
}

/// The keys of `motion`.
std::vector<Key> motion_keys();

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
