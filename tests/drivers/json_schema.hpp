// SPDX-License-Identifier: BSD-3-Clause
// A validator of JSON Schema, of the keywords that the program's schemas use.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "drivers/format/yaml_reader.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

using nlohmann::json;

inline json json_of(const Tree& tree) {
  switch (tree.kind) {
    case Tree::Kind::null:
      return nullptr;
    case Tree::Kind::sequence: {
      json list = json::array();
      for (const Tree& item : tree.items) list.push_back(json_of(item));
      return list;
    }
    case Tree::Kind::map: {
      json map = json::object();
      for (const Tree::Entry& entry : tree.entries) map[entry.key] = json_of(entry.value);
      return map;
    }
    case Tree::Kind::scalar:
      break;
  }
  if (!tree.quoted && tree.text == "true") return true;
  if (!tree.quoted && tree.text == "false") return false;
  if (const auto number = parse_number(tree.text); number && !tree.quoted && std::isfinite(*number)) return *number;
  return tree.text;
}

inline bool is_of_type(const json& value, const std::string& type) {
  if (type == "integer") return value.is_number() && std::floor(value.get<double>()) == value.get<double>();
  if (type == "number") return value.is_number();
  if (type == "string") return value.is_string();
  if (type == "boolean") return value.is_boolean();
  if (type == "array") return value.is_array();
  if (type == "object") return value.is_object();
  ADD_FAILURE() << "type " << type;
  return false;
}

inline bool within(const json& schema, double value) {
  return !(schema.contains("minimum") && value < schema["minimum"].get<double>()) &&
         !(schema.contains("maximum") && value > schema["maximum"].get<double>()) &&
         !(schema.contains("exclusiveMinimum") && value <= schema["exclusiveMinimum"].get<double>()) &&
         !(schema.contains("exclusiveMaximum") && value >= schema["exclusiveMaximum"].get<double>());
}

inline bool valid(const json& schema, const json& value);

inline bool valid_object(const json& schema, const json& value) {
  const json properties = schema.value("properties", json::object()),
             patterns = schema.value("patternProperties", json::object()),
             more = schema.value("additionalProperties", json(true));
  for (const auto& name : schema.value("required", json::array())) {
    if (!value.contains(name)) return false;
  }
  if (value.size() < schema.value("minProperties", 0u) || value.size() > schema.value("maxProperties", 1000u))
    return false;
  for (const auto& [name, member] : value.items()) {
    bool known = properties.contains(name);
    if (known && !valid(properties[name], member)) return false;
    for (const auto& [pattern, inside] : patterns.items()) {
      if (!std::regex_search(name, std::regex(pattern))) continue;
      known = true;
      if (!valid(inside, member)) return false;
    }
    if (!known && (more.is_boolean() ? !more.get<bool>() : !valid(more, member))) return false;
  }
  return true;
}

inline bool valid_array(const json& schema, const json& value) {
  if (value.size() < schema.value("minItems", 0u) || value.size() > schema.value("maxItems", 1000u)) return false;
  return std::all_of(value.begin(), value.end(),
                     [&](const json& v) { return !schema.contains("items") || valid(schema["items"], v); });
}

/// The keywords of JSON Schema that the program uses; any other fails the test.
inline bool valid(const json& schema, const json& value) {
  static const std::set<std::string> keywords{
      "$schema",          "title", "description", "default",  "type",    "properties",        "additionalProperties",
      "required",         "items", "minItems",    "maxItems", "minimum", "maximum",           "exclusiveMinimum",
      "exclusiveMaximum", "enum",  "const",       "oneOf",    "anyOf",   "patternProperties", "minProperties",
      "maxProperties",    "$id"};
  for (const auto& [name, ignored] : schema.items()) EXPECT_TRUE(keywords.count(name)) << name;
  if (schema.contains("type")) {
    const json types = schema["type"].is_array() ? schema["type"] : json::array({schema["type"]});
    if (std::none_of(types.begin(), types.end(), [&](const json& t) { return is_of_type(value, t); })) return false;
  }
  if (schema.contains("const") && schema["const"] != value) return false;
  if (schema.contains("enum") && std::count(schema["enum"].begin(), schema["enum"].end(), value) == 0) return false;
  if (schema.contains("oneOf") && std::count_if(schema["oneOf"].begin(), schema["oneOf"].end(),
                                                [&](const json& s) { return valid(s, value); }) != 1) {
    return false;
  }
  if (schema.contains("anyOf") &&
      std::none_of(schema["anyOf"].begin(), schema["anyOf"].end(), [&](const json& s) { return valid(s, value); })) {
    return false;
  }
  if (value.is_number() && !within(schema, value.get<double>())) return false;
  if (value.is_object() && !valid_object(schema, value)) return false;
  return !value.is_array() || valid_array(schema, value);
}

}  // namespace assay::drivers
