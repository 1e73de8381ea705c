// SPDX-License-Identifier: BSD-3-Clause
// A scene with every key and default, as YAML.
#include "drivers/scene/scene_reader.hpp"

#include "drivers/format/yaml_writer.hpp"
#include "drivers/scene/expect.hpp"
#include "drivers/scene/key_values.hpp"

namespace assay::drivers {

namespace {

std::string keys_text(const std::string& section, const Scene& scene) {
  std::string text;
  for (const Key& key : scene_keys()) {
    if (parent_of(key.path) != section || !applies(key, scene)) continue;
    const Value value = key.get(scene);
    if (value.index() == 0) continue;
    const std::string written = value_text(key, value);
    text += indent_of_key(key.path) + last_part(key.path) + (written.starts_with('\n') ? ":" : ": ") + written + "\n";
  }
  return text;
}

std::string free_text(const std::string& section, const Scene& scene) {
  std::string text;
  const auto add = [&](const std::string& key, const std::string& value) {
    text += indent_of_key(section + ".") + yaml_scalar(key) + ": " + value + "\n";
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
    if (!inside.empty()) text += indent_of_key(section.path) + last_part(section.path) + ":\n" + inside;
  }
  return text;
}

}  // namespace assay::drivers
