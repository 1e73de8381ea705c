// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/scene/resolved.hpp"

#include <algorithm>
#include <cstdint>

#include "drivers/format/yaml_writer.hpp"
#include "drivers/scene/expect.hpp"
#include "drivers/scene/scene_keys.hpp"

namespace assay::drivers {

namespace {

/// A whole number has no exponent: readers take it for one.
std::string number_of(const Key& key, double value) {
  return key.range.whole ? std::to_string(static_cast<std::int64_t>(value)) : yaml_number(value);
}

std::string list_text(const Key& key, const std::vector<double>& values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : ", ") + number_of(key, value);
  return "[" + text + "]";
}

std::string value_text(const Key& key, const Value& value) {
  if (const auto* truth = std::get_if<bool>(&value)) return *truth ? "true" : "false";
  if (const auto* number = std::get_if<double>(&value)) return number_of(key, *number);
  if (const auto* text = std::get_if<std::string>(&value)) return yaml_scalar(*text);
  const auto& list = std::get<std::vector<double>>(value);
  if (key.type != KeyType::matrix) return list_text(key, list);
  const auto row = [&](int k) { return list_text(key, {list.begin() + 3 * k, list.begin() + 3 * k + 3}); };
  return "[" + row(0) + ", " + row(1) + ", " + row(2) + "]";
}

std::string indent(const std::string& path) {
  return std::string(2 * static_cast<std::size_t>(std::count(path.begin(), path.end(), '.')), ' ');
}

std::string last_word(const std::string& path) { return path.substr(path.rfind('.') + 1); }

std::string keys_text(const std::string& section, const Scene& scene) {
  std::string text;
  for (const Key& key : scene_keys()) {
    const std::size_t dot = key.path.rfind('.');
    if ((dot == key.path.npos ? std::string() : key.path.substr(0, dot)) != section || !applies(key, scene)) continue;
    const Value value = key.get(scene);
    if (value.index() == 0) continue;
    text += indent(key.path) + last_word(key.path) + ": " + value_text(key, value) + "\n";
  }
  return text;
}

std::string free_text(const std::string& section, const Scene& scene) {
  std::string text;
  if (section == "material.parameters") {
    for (const auto& [name, value] : scene.material.parameters) {
      text += "    " + yaml_scalar(name) + ": " + yaml_number(value) + "\n";
    }
  } else {
    for (const Expectation& line : scene.expect) {
      text += "  " + yaml_scalar(line.key) + ": " + expectation_yaml(line) + "\n";
    }
  }
  return text;
}

}  // namespace

std::string resolved_yaml(const Scene& scene) {
  std::string text = keys_text("", scene);
  for (const Section& section : scene_sections()) {
    const std::string inside = section.free_keys ? free_text(section.path, scene) : keys_text(section.path, scene);
    if (!inside.empty()) text += indent(section.path) + last_word(section.path) + ":\n" + inside;
  }
  return text;
}

}  // namespace assay::drivers
