// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/material_description.hpp"

#include <filesystem>

#include "drivers/material/material_path.hpp"
#include "drivers/output/numbers.hpp"
#include "drivers/scene/yaml_values.hpp"

namespace assay::drivers {

MaterialDescription read_description(const std::string& file) {
  const Tree root = read_yaml(read_bytes(file), file);
  const std::vector<std::string> known{"library", "name", "interface", "parameters", "density"};
  require_map(root, "", joined(known));
  refuse_unknown_keys(root, "", known);
  MaterialDescription description;
  const Tree* library = root.find("library");
  if (!library) throw InputError(root.where, "library", "required and not given", joined(known));
  const std::filesystem::path path = text_value(*library, "library");
  description.library = absolute_path(std::filesystem::path(file).parent_path() / path);
  description.library_where = description.name_where = library->where;
  if (const Tree* interface = root.find("interface")) choice_value(*interface, "interface", {"native"});
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
  return description;
}

std::string description_yaml(const MaterialDescription& description) {
  std::string text = "library: " + yaml_scalar(description.library) + "\n";
  if (!description.name.empty()) text += "name: " + yaml_scalar(description.name) + "\n";
  text += "interface: native\n";
  if (!description.parameters.empty()) text += "parameters:\n";
  for (const auto& [name, value] : description.parameters) {
    text += "  " + yaml_scalar(name) + ": " + number_text(value) + "\n";
  }
  if (description.density) text += "density: " + number_text(*description.density) + "\n";
  return text;
}

}  // namespace assay::drivers
