// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <iterator>

#include "drivers/format/yaml_writer.hpp"
#include "drivers/material/foreign_description.hpp"
#include "drivers/material/foreign_words.hpp"

namespace assay::drivers {

using namespace foreign_words;
using adapters::ForeignModel;
using adapters::ForeignProperty;
using adapters::ForeignVariable;
using adapters::Kinematics;

namespace {

std::string word_of(double value, const Units& units) {
  const auto found = std::find_if(units.begin(), units.end(), [&](const auto& unit) { return unit.second == value; });
  return found == units.end() ? "" : found->first;
}

std::string listed(const std::vector<std::string>& words) { return "[" + joined(words) + "]"; }

/// "{value: 1, unit: Pa}".
class FlowMap {
 public:
  void add(const std::string& key, const std::string& text) {
    text_ += (text_.empty() ? "" : ", ") + key + ": " + text;
  }
  void add_words(const std::string& key, const std::string& words) {
    if (!words.empty()) add(key, yaml_scalar(words));
  }
  std::string text() const { return "{" + text_ + "}"; }

 private:
  std::string text_;
};

std::string property_text(const ForeignProperty& p) {
  FlowMap map;
  if (std::isfinite(p.value)) map.add("value", yaml_number(p.value));
  map.add_words("unit", p.unit);
  if (std::isfinite(p.lower)) map.add("lower", yaml_number(p.lower));
  if (std::isfinite(p.upper)) map.add("upper", yaml_number(p.upper));
  map.add_words("doc", p.doc);
  return map.text();
}

std::string variable_text(const ForeignVariable& v) {
  FlowMap map;
  if (v.kind_is_said) map.add("kind", kinds[static_cast<std::size_t>(v.kind)]);
  std::vector<std::string> numbers;
  for (const double value : v.initial) numbers.push_back(yaml_number(value));
  if (numbers.size() == 1) map.add("initial", numbers.front());
  if (numbers.size() > 1) map.add("initial", listed(numbers));
  map.add_words("unit", v.unit);
  map.add_words("doc", v.doc);
  return map.text();
}

std::string fields_text(const ForeignModel& model) {
  FlowMap map;
  for (const auto& field : model.fields) map.add(yaml_scalar(field.name), yaml_number(field.value));
  return map.text();
}

/// What keys_of_abaqus() names.
std::string abaqus_yaml(const ForeignModel& model) {
  std::string text;
  const auto line = [&](const std::string& key, const std::string& value) { text += key + ": " + value + "\n"; };
  line("kinematics", model.kinematics == Kinematics::abaqus ? "abaqus" : "objective");
  line("axes", axes_words[static_cast<std::size_t>(model.axes)]);
  line("step", std::to_string(model.step));
  if (model.element != 1) line("noel", std::to_string(model.element));
  if (model.point != 1) line("npt", std::to_string(model.point));
  if (model.each_its_element) line("elements", "each");
  if (model.strain_is_said) line("strain", model.finite_strain ? "finite" : "small");
  std::vector<std::string> components;
  for (const int n : model.components) components.push_back(std::to_string(n));
  if (model.components_are_said) line("components", listed(components));
  line("characteristic_length", yaml_number(model.characteristic_length));
  line("material_name", yaml_scalar(model.material_name));
  return text;
}

}  // namespace

const std::vector<std::string>& interface_names() {
  static const std::vector<std::string> names{"native", "umat", "vumat", "mfront"};
  return names;
}

const std::vector<std::string>& foreign_keys() {
  static const std::vector<std::string> keys{
      "symbol",        "properties", "state", "kinematics",  "axes",   "strain", "symmetry",
      "flags",         "components", "units", "temperature", "fields", "step",   "characteristic_length",
      "material_name", "noel",       "npt",   "elements"};
  return keys;
}

const std::vector<std::string>& keys_of_abaqus() {
  static const std::vector<std::string> keys{
      "kinematics",    "axes", "strain", "components", "step", "characteristic_length",
      "material_name", "noel", "npt",    "elements"};
  return keys;
}

std::string foreign_yaml(const ForeignModel& model) {
  std::string text;
  const auto line = [&](const std::string& key, const std::string& value) { text += key + ": " + value + "\n"; };
  line("interface", interface_names()[static_cast<std::size_t>(model.interface) + 1]);
  line("symbol", yaml_scalar(model.symbol));
  if (!model.properties.empty()) text += "properties:\n";
  for (const ForeignProperty& p : model.properties) line("  " + yaml_scalar(p.name), property_text(p));
  if (!model.state.empty()) text += "state:\n";
  for (const ForeignVariable& v : model.state) line("  " + yaml_scalar(v.name), variable_text(v));
  if (!model.fields.empty()) line("fields", fields_text(model));
  if (model.symmetry_is_said)
    line("symmetry", symmetries[static_cast<std::size_t>(model.symmetry + model.material_class)]);
  std::vector<std::string> flags;
  for (std::size_t k = 0; k < std::size(flag_bits); ++k) {
    if (model.flags & flag_bits[k]) flags.push_back(flag_words[k]);
  }
  if (model.flags_are_said) line("flags", listed(flags));
  line("units", "{stress: " + word_of(model.units.stress, stress_units) +
                    ", time: " + word_of(model.units.time, time_units) +
                    ", length: " + word_of(model.units.length, length_units) + "}");
  if (model.temperature_is_said) line("temperature", yaml_number(model.temperature));
  return model.interface == adapters::ForeignInterface::mfront ? text : text + abaqus_yaml(model);
}

}  // namespace assay::drivers
