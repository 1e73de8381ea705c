// SPDX-License-Identifier: BSD-3-Clause
// `assay check`: the battery of model tests, for people, for scripts and for CI.
#include <chrono>
#include <cstdio>
#include <iostream>

#include "drivers/check_report.hpp"
#include "drivers/interrupt.hpp"
#include "drivers/material/material_choice.hpp"
#include "drivers/material/material_path.hpp"
#include "drivers/output/numbers.hpp"
#include "drivers/output/whole_file.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/scene/yaml_reader.hpp"
#include "drivers/verbs.hpp"

namespace assay::drivers {

namespace {

/// "E=1e3,nu=0.3": names and numbers.
std::map<std::string, double> parameters_in(const std::string& list) {
  std::map<std::string, double> parameters;
  for (std::size_t begin = 0; begin < list.size();) {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    const std::string item = list.substr(begin, end - begin);
    const std::size_t equals = item.find('=');
    const auto value = equals == std::string::npos ? std::nullopt : parse_number(item.substr(equals + 1));
    if (!value || equals == 0) {
      throw InputError({}, "--parameters",
                       "must be NAME=NUMBER, separated by commas, found '" + one_line(item, 60) + "'");
    }
    if (!parameters.emplace(item.substr(0, equals), *value).second) {
      throw InputError({}, "--parameters", "'" + one_line(item.substr(0, equals), 60) + "' is given twice");
    }
    begin = end + 1;
  }
  return parameters;
}

/// A scene is a YAML file that has a motion; a description of a material has none.
bool is_scene(const std::string& material) {
  const MaterialName name = parse_material(material);
  if (!name.is_path || !name.table.empty() || !(name.file.ends_with(".yaml") || name.file.ends_with(".yml"))) {
    return false;
  }
  return read_yaml(read_bytes(name.file), name.file).find("motion") != nullptr;
}

ResolvedMaterial material_to_check(const CheckOptions& options) {
  MaterialChoice choice;
  if (is_scene(options.material)) {
    choice = read_scene(options.material).material;
  } else {
    choice.adapter = options.material;
  }
  for (const auto& [name, value] : parameters_in(options.parameters)) choice.parameters[name] = value;
  if (!(choice.density > 0)) choice.density = 1;  // no test needs one
  return resolve_material(choice);
}

}  // namespace

int check(const CheckOptions& options) {
  if (options.methods) return check_methods(options);
  const ResolvedMaterial resolved = material_to_check(options);
  watch_interrupts();
  const auto start = std::chrono::steady_clock::now();
  CheckedMaterial checked{options.material, resolved.library, {}, {}, 0};
  for (std::uint32_t i = 0; i < resolved.material.table().parameter_count; ++i) {
    checked.parameters.emplace_back(resolved.material.table().parameters[i].name, resolved.material.parameters()[i]);
  }
  checked.report = check::run_battery(resolved.material, {.quick = options.quick});
  checked.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  stop_if_interrupted();
  const bool json_on_output = options.json == "-", junit_on_output = options.junit == "-";
  if (!options.json.empty() && !json_on_output) write_file(options.json, check_json(checked));
  if (!options.junit.empty() && !junit_on_output) write_file(options.junit, check_junit(checked));
  if (json_on_output) std::cout << check_json(checked);
  if (junit_on_output) std::cout << check_junit(checked);
  if (!json_on_output && !junit_on_output) std::cout << check_text(checked, options.verbosity);
  return checked.report.passes() ? 0 : 1;
}

}  // namespace assay::drivers
