// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/material_description.hpp"

#include <cctype>
#include <filesystem>

#include "drivers/material/foreign_description.hpp"
#include "drivers/material/material_path.hpp"
#include "drivers/scene/yaml_values.hpp"
#include "drivers/scene/yaml_writer.hpp"

namespace assay::drivers {

namespace {

/// native, umat, ...
std::string interface_of(const Tree& root) {
  const Tree* tree = root.find("interface");
  return tree ? choice_value(*tree, "interface", interface_names()) : "native";
}

std::vector<std::string> keys_of(const std::string& interface) {
  std::vector<std::string> known{"library", "name", "interface", "density", "time_limit", "memory_limit"};
  const std::vector<std::string> native{"parameters"}, &more = interface == "native" ? native : foreign_keys();
  known.insert(known.end(), more.begin(), more.end());
  return known;
}

/// Relative to the description; a bare name that is not there, in a folder of $ASSAY_MATERIAL_PATH.
std::string library_file(const std::string& said, const std::filesystem::path& folder) {
  std::string beside = absolute_path(folder / said);
  std::error_code code;
  if (said.find('/') != std::string::npos || std::filesystem::exists(beside, code)) return beside;
  for (const std::string& other : material_folders()) {
    std::string found = absolute_path(std::filesystem::path(other) / said);
    if (std::filesystem::exists(found, code)) return found;
  }
  return beside;
}

/// A file's name as the name of a table: "My-Clay.yaml" is my_clay.
std::string name_of_file(const std::string& file) {
  std::string name = std::filesystem::path(file).stem().string();
  for (char& c : name) {
    const auto u = static_cast<unsigned char>(c);
    c = std::isalnum(u) ? static_cast<char>(std::tolower(u)) : '_';
  }
  return name;
}

}  // namespace

MaterialDescription read_description(const std::string& file) { return read_description(read_bytes(file), file); }

MaterialDescription read_description(const std::string& text, const std::string& file) {
  const Tree root = read_yaml(text, file);
  require_map(root, "", joined(keys_of("native")));
  const std::string interface = interface_of(root);
  const std::vector<std::string> known = keys_of(interface);
  refuse_unknown_keys(root, "", known);
  MaterialDescription description;
  const Tree* library = root.find("library");
  if (!library) throw InputError(root.where, "library", "required and not given", joined(known));
  description.library = library_file(text_value(*library, "library"), std::filesystem::path(file).parent_path());
  description.library_where = description.name_where = library->where;
  if (const Tree* name = root.find("name")) {
    description.name = text_value(*name, "name");
    description.name_where = name->where;
  }
  if (const Tree* parameters = root.find("parameters")) {
    require_map(*parameters, "parameters", "the parameters of the material");
    for (const Tree::Entry& entry : parameters->entries) {
      const std::string key = "parameters." + one_line(entry.key, 80);
      description.parameters[entry.key] = number_value(entry.value, key);
      description.parameter_where[entry.key] = entry.value.where;
    }
  }
  if (const Tree* density = root.find("density")) {
    description.density = number_value(*density, "density", {.lower = 0, .lower_open = true});
  }
  if (const Tree* limit = root.find("time_limit")) {
    description.limits.seconds = number_value(*limit, "time_limit", {.lower = 0, .upper = 1e7, .lower_open = true});
  }
  if (const Tree* limit = root.find("memory_limit")) {
    description.limits.gigabytes = number_value(*limit, "memory_limit", {.lower = 0, .upper = 1e6, .lower_open = true});
  }
  if (interface != "native") {
    if (description.name.empty()) description.name = name_of_file(file);
    description.foreign = read_foreign(root, interface, description.library, description.name, description.key_where);
  }
  return description;
}

std::string description_yaml(const MaterialDescription& description) {
  std::string text = "library: " + yaml_scalar(description.library) + "\n";
  if (!description.name.empty()) text += "name: " + yaml_scalar(description.name) + "\n";
  text += description.foreign ? foreign_yaml(*description.foreign) : "interface: native\n";
  if (!description.parameters.empty()) text += "parameters:\n";
  for (const auto& [name, value] : description.parameters) {
    text += "  " + yaml_scalar(name) + ": " + yaml_number(value) + "\n";
  }
  const adapters::WorkerLimits usual;
  if (description.limits.seconds != usual.seconds) {
    text += "time_limit: " + yaml_number(description.limits.seconds) + "\n";
  }
  if (description.limits.gigabytes != usual.gigabytes) {
    text += "memory_limit: " + yaml_number(description.limits.gigabytes) + "\n";
  }
  if (description.density) text += "density: " + yaml_number(*description.density) + "\n";
  return text;
}

}  // namespace assay::drivers
