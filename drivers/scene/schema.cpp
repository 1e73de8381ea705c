// SPDX-License-Identifier: BSD-3-Clause
// The JSON Schema of scenes.
#include "drivers/scene/scene_keys.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "drivers/result/json_fields.hpp"
#include "drivers/result/result.hpp"
#include "drivers/result/result_json.hpp"
#include "drivers/scene/expect.hpp"
#include "harness/motion/registry.hpp"

namespace assay::drivers {

namespace {

using Json = nlohmann::ordered_json;

/// Every kind of scene, with the optional parts present: what the table's keys are asked for their defaults.
std::vector<Scene> kinds_of_scene() {
  Scene ring;
  ring.grid.emplace(), ring.method.emplace(), ring.frame.emplace(), ring.body.initial_velocity.emplace();
  std::vector<Scene> kinds{ring};
  const auto add = [&](const Motion& motion, Body::Domain domain) {
    kinds.push_back(ring);
    kinds.back().motion = motion;
    kinds.back().body.domain = domain;
  };
  for (const Motion& motion : motion_registry().samples()) {
    if (motion->type() == ring.motion->type()) continue;
    add(motion, ring_of(motion) ? Body::Domain::ring : Body::Domain::square);
  }
  add(ring.motion, Body::Domain::box);
  return kinds;
}

Json number_schema(const Range& range) {
  Json out{{"type", range.whole ? "integer" : "number"}};
  if (std::isfinite(range.lower)) out[range.lower_open ? "exclusiveMinimum" : "minimum"] = range.lower;
  if (std::isfinite(range.upper)) out[range.upper_open ? "exclusiveMaximum" : "maximum"] = range.upper;
  return out;
}

Json list_schema(const Json& items, int fewest, int most) {
  return {{"type", "array"}, {"items", items}, {"minItems", fewest}, {"maxItems", most}};
}
Json list_schema(const Json& items, int count) { return list_schema(items, count, count); }

/// A map of one operator.
Json operator_schema(const std::string& name, const Json& value) {
  Json one{{"type", "object"}, {"additionalProperties", false}, {"required", Json::array({name})}};
  one["properties"][name] = value;
  return one;
}

Json default_of(const Key& key) {
  for (const Scene& scene : kinds_of_scene()) {
    if (!applies(key, scene)) continue;
    const Value value = key.get(scene);
    if (value.index() != 0) return JsonFields<Json>::of(value);
  }
  return nullptr;
}

/// A map with these members and no others, besides what is merged into it.
Json map_schema(const Json& properties, const Json& required) {
  Json out{{"type", "object"},
           {"additionalProperties", false},
           {"properties", properties},
           {"patternProperties", {{merge_pattern, Json::object()}}}};
  if (!required.empty()) out["required"] = required;
  return out;
}

Json key_schema(const Key& key) {
  Json out = type_schema(key);
  std::string doc = doc_of(key);
  if (!key.derived.empty()) doc += "; default: " + key.derived;
  out["description"] = doc;
  if (!key.required && key.derived.empty()) out["default"] = default_of(key);
  return out;
}

Json free_section(const Section& section) {
  Json out{{"type", "object"}, {"description", section.doc}, {"patternProperties", {{merge_pattern, Json::object()}}}};
  if (section.path == "expect") {
    out["additionalProperties"] = false;
    for (const char* key : {order_key, last_order_key}) {
      out["properties"][key] = expectation_schema(key, {});
      out["properties"][key]["description"] =
          key == std::string(order_key) ? "observed order over all grids of `judge`; `run` passes over it"
                                        : "order between the two finest grids of `judge`; `run` passes over it";
    }
    for (const std::string& key : flat_keys()) out["properties"][key] = expectation_schema(key, known_outcomes());
  } else {
    out["additionalProperties"] = {{"type", "number"}};
  }
  return out;
}

Json item_schema(const Key& list) {
  Json properties = Json::object(), required = Json::array();
  for (const Key& key : list.items) {
    properties[key.path] = key_schema(key);
    if (key.required) required.push_back(key.path);
  }
  return map_schema(properties, required);
}

/// The section whose alternatives are the motions; in others every key is listed that some motion knows.
bool is_of_motion(const std::string& section) { return section.starts_with("motion"); }

/// One alternative for each motion where the keys of a section depend on it.
Json object_schema(const std::string& path, const Scene& scene) {
  Json properties = Json::object(), required = Json::array();
  for (const Key& key : scene_keys()) {
    if (parent_of(key.path) != path || (is_of_motion(path) && !of_motion(key, scene))) continue;
    const std::string name = last_part(key.path);
    properties[name] = key_schema(key);
    if (key.path == "motion.type") properties[name] = {{"const", motion_type(scene)}, {"description", key.doc}};
    if (key.required) required.push_back(name);
  }
  for (const Section& section : scene_sections()) {
    if (parent_of(section.path) != path || (is_of_motion(section.path) && !applies(section, scene))) continue;
    const std::string name = last_part(section.path);
    Json& part = properties[name] = section.free_keys ? free_section(section) : object_schema(section.path, scene);
    part["description"] = section.doc;
    if (section.required) required.push_back(name);
  }
  Json out = map_schema(properties, required);
  if (path.empty()) out["patternProperties"][anchors_pattern] = Json::object();
  return out;
}

}  // namespace

std::string schema_id(const std::string& what) {
  return "urn:assay:schema:" + what + ":" + build_information().version;
}

nlohmann::ordered_json type_schema(const Key& key) {
  switch (key.type) {
    case KeyType::number:
      return number_schema(key.range);
    case KeyType::automatic:
      return {{"oneOf", Json::array({number_schema(key.range), Json{{"const", "auto"}}})}};
    case KeyType::boolean:
      return {{"type", "boolean"}};
    case KeyType::text:
      return {{"type", Json::array({"string", "number", "boolean"})}};
    case KeyType::choice:
      return {{"enum", key.choices}};
    case KeyType::pair:
      return list_schema(number_schema(key.range), 2);
    case KeyType::vector:
      return list_schema(number_schema(key.range), 3);
    case KeyType::six:
      return list_schema(number_schema(key.range), 6);
    case KeyType::pair_or_vector:
    case KeyType::per_axis:
      return list_schema(number_schema(key.range), 2, 3);
    case KeyType::matrix:
      return list_schema(list_schema(number_schema(key.range), 3), 3);
    case KeyType::list:
      return {{"type", "array"}, {"items", item_schema(key)}, {"minItems", 1}};
  }
  return {};
}

nlohmann::ordered_json expectation_schema(const std::string& key, const std::vector<std::string>& outcomes) {
  const Field figure = figure_of_result(key);
  Json out = Json::object(), values = Json::array();
  const bool has_unit = !figure.unit.empty() && figure.unit != "1";
  if (!figure.doc.empty()) out["description"] = figure.meaning() + (has_unit ? " [" + figure.unit + "]" : "");
  if (figure.kind == Field::Kind::number) {
    const Json number{{"type", "number"}};
    for (const std::string& name : words_of<Expectation::Operator>())
      values.push_back(operator_schema(name, name == "between" ? list_schema(number, 2) : number));
    values.push_back(number);
  } else {
    const bool is_truth = figure.kind == Field::Kind::truth;
    const Json one = key == "outcome" ? Json{{"enum", outcomes}} : Json{{"type", is_truth ? "boolean" : "string"}};
    values = Json::array({one, operator_schema("equals", one)});
  }
  out["oneOf"] = values;
  return out;
}

std::string schema_json() {
  const std::vector<Scene> kinds = kinds_of_scene();
  Json out = object_schema("", kinds[0]);
  const std::string doc = out["properties"]["motion"]["description"];
  Json motions = Json::array();
  for (std::size_t k = 0; k + 1 < kinds.size(); ++k) motions.push_back(object_schema("motion", kinds[k]));
  out["properties"]["motion"] = {{"description", doc}, {"oneOf", motions}};
  Json head{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
            {"$id", schema_id("scene")},
            {"title", "assay scene"}};
  head.update(out);
  return head.dump(2) + "\n";
}

}  // namespace assay::drivers
