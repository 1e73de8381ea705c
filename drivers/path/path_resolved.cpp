// SPDX-License-Identifier: BSD-3-Clause
// A path written in full: every row, also those of its type and those that hold a component.
#include "drivers/format/yaml_writer.hpp"
#include "drivers/path/path_scene.hpp"
#include "drivers/scene/expect.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

std::string material_text(const MaterialChoice& material, const std::string& indent) {
  std::string text = indent + "adapter: " + yaml_scalar(material.adapter) + "\n";
  if (!material.parameters.empty()) {
    text += indent + "parameters:\n";
    for (const auto& [name, value] : material.parameters)
      text += indent + "  " + yaml_scalar(name) + ": " + yaml_number(value) + "\n";
  }
  if (material.density > 0) text += indent + "density: " + yaml_number(material.density) + "\n";
  if (material.direction) {
    const auto& d = *material.direction;
    text += indent + "direction: [" + yaml_number(d[0]) + ", " + yaml_number(d[1]) + ", " + yaml_number(d[2]) + "]\n";
  }
  if (material.isolation != Isolation::automatic)
    text += indent + "isolation: " + (material.isolation == Isolation::worker ? "worker" : "none") + "\n";
  return text;
}

std::string stop_text(const PathStop& stop) {
  using When = ControlStop::When;
  if (stop.when == When::loss_of_ellipticity) return "loss_of_ellipticity";
  if (stop.when == When::peak) return "{peak: " + yaml_scalar(stop.quantity.text) + "}";
  return std::string(stop.when == When::above ? "{above: {" : "{below: {") + yaml_scalar(stop.quantity.text) + ": " +
         yaml_number(stop.bound) + "}}";
}

/// Of a stage only the rows that are given: the others follow from where it begins.
std::string section_text(const PathScene& scene, const std::string& indent, bool of_stage) {
  std::string text = indent + "type: " + (of_stage ? scene.type : "general") + "\n", six;
  bool stressed = false;
  for (const double value : scene.initial_stress) {
    stressed = stressed || value != 0;
    six += (six.empty() ? "" : ", ") + yaml_number(value);
  }
  if (stressed) text += indent + "initial_stress: [" + six + "]\n";
  text += indent + "end: " + yaml_number(scene.end) + "\n" + indent + "rows: " + std::to_string(scene.count) + "\n" +
          indent + "calls: " + yaml_number(scene.most_calls) + "\n" + indent +
          "tolerance: " + yaml_number(scene.tolerance) + "\n" + indent + "control:\n";
  for (const PathRow& row : scene.rows) {
    if (!of_stage || row.origin == PathRow::Origin::given)
      text += indent + "  " + yaml_scalar(row.quantity.text) + ": " + path_function_yaml(row.value) + "\n";
  }
  if (!scene.fields.empty()) text += indent + "fields:\n";
  for (const PathField& field : scene.fields)
    text += indent + "  " + yaml_scalar(field.name) + ": " + path_function_yaml(field.value) + "\n";
  if (!scene.stops.empty()) text += indent + "stop:\n";
  for (const PathStop& stop : scene.stops) text += indent + "  - " + stop_text(stop) + "\n";
  return text;
}

std::string item_text(const PathScene& stage) {
  std::string text = section_text(stage, "    ", true);
  text[2] = '-';
  return text;
}

}  // namespace

std::string resolved_path_yaml(const PathScene& scene) {
  std::string text;
  if (!scene.title.empty()) text += "title: " + yaml_scalar(scene.title) + "\n";
  text += "material:\n" + material_text(scene.material, "  ");
  if (scene.later.empty()) {
    text += "path:\n" + section_text(scene, "  ", false);
  } else {
    text += "stages:\n" + item_text(scene);
    for (const PathScene& stage : scene.later) text += item_text(stage);
  }
  if (!scene.variants.empty()) text += "variants:\n";
  for (const PathVariant& variant : scene.variants)
    text += "  - label: " + yaml_scalar(variant.label) + "\n" + material_text(variant.material, "    ");
  if (scene.compare) {
    const PathComparison& c = *scene.compare;
    const auto unit = [](const char* key, const std::string& word) {
      return parse_unit(word)->scale.is_one() ? "" : std::string("\n  ") + key + ": " + yaml_scalar(word);
    };
    text += "compare:\n  file: " + yaml_scalar(c.file) + "\n  x: " + yaml_scalar(c.x.terms.empty() ? "t" : c.x.text) +
            "\n  y: " + yaml_scalar(c.y.text) + "\n  x_column: " + yaml_scalar(c.y_of_x.time) +
            (c.y_of_x.column.empty() ? "" : "\n  y_column: " + yaml_scalar(c.y_of_x.column)) +
            unit("x_unit", c.y_of_x.time_unit) + unit("y_unit", c.y_of_x.unit) + "\n";
  }
  if (!scene.increments.empty()) {
    std::vector<std::string> counts;
    for (const int count : scene.increments) counts.push_back(std::to_string(count));
    text += "increments: " + flow_list(counts) + "\n";
  }
  if (scene.iso_error) {
    const IsoErrorChoice& map = *scene.iso_error;
    text += "iso_error: {from: [" + yaml_number(map.e11) + ", " + yaml_number(map.e22) +
            "], unit: " + yaml_number(map.unit) + ", reach: " + yaml_number(map.reach) +
            ", points: " + std::to_string(map.points) + "}\n";
  }
  if (!scene.expect.empty()) text += "expect:\n";
  for (const Expectation& line : scene.expect)
    text += "  " + yaml_scalar(line.key) + ": " + expectation_yaml(line) + "\n";
  return text;
}

}  // namespace assay::drivers
