// SPDX-License-Identifier: BSD-3-Clause
// A scene with every key and default, as YAML.
#include "drivers/scene/scene_reader.hpp"

#include <algorithm>
#include <cstdint>
#include <span>

#include "drivers/format/yaml_writer.hpp"
#include "drivers/scene/expect.hpp"
#include "drivers/scene/scene_keys.hpp"

namespace assay::drivers {

namespace {

/// A whole number has no exponent: readers take it for one.
std::string number_of(const Key& key, double value) {
  return key.range.whole ? std::to_string(static_cast<std::int64_t>(value)) : yaml_number(value);
}

std::string list_text(const Key& key, std::span<const double> values) {
  return flow_list(mapped(values, [&](double value) { return number_of(key, value); }));
}

std::string value_text(const Key& key, const Value& value) {
  if (const auto* truth = std::get_if<bool>(&value)) return *truth ? "true" : "false";
  if (const auto* number = std::get_if<double>(&value)) return number_of(key, *number);
  if (const auto* text = std::get_if<std::string>(&value)) return yaml_scalar(*text);
  const std::span<const double> list = std::get<std::vector<double>>(value);
  if (key.type != KeyType::matrix) return list_text(key, list);
  return flow_list(
      {list_text(key, list.subspan(0, 3)), list_text(key, list.subspan(3, 3)), list_text(key, list.subspan(6, 3))});
}

std::string indent(const std::string& path) {
  return std::string(2 * static_cast<std::size_t>(std::count(path.begin(), path.end(), '.')), ' ');
}

std::string keys_text(const std::string& section, const Scene& scene) {
  std::string text;
  for (const Key& key : scene_keys()) {
    if (parent_of(key.path) != section || !applies(key, scene)) continue;
    const Value value = key.get(scene);
    if (value.index() == 0) continue;
    text += indent(key.path) + last_part(key.path) + ": " + value_text(key, value) + "\n";
  }
  return text;
}

std::string free_text(const std::string& section, const Scene& scene) {
  std::string text;
  const auto add = [&](const std::string& key, const std::string& value) {
    text += indent(section + ".") + yaml_scalar(key) + ": " + value + "\n";
  };
  if (section == "expect") {
    for (const Expectation& line : scene.expect) add(line.key, expectation_yaml(line));
  } else {
    for (const auto& [name, value] : scene.material.parameters) add(name, yaml_number(value));
  }
  return text;
}

}  // namespace

std::string resolved_yaml(const Scene& scene) {
  std::string text = keys_text("", scene);
  for (const Section& section : scene_sections()) {
    const std::string inside = section.free_keys ? free_text(section.path, scene) : keys_text(section.path, scene);
    if (!inside.empty()) text += indent(section.path) + last_part(section.path) + ":\n" + inside;
  }
  return text;
}

}  // namespace assay::drivers
