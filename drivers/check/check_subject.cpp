// SPDX-License-Identifier: BSD-3-Clause
// What `assay check` is asked to check.
#include <algorithm>
#include <optional>

#include "drivers/check/check.hpp"
#include "drivers/check/replay.hpp"
#include "drivers/format/number_slips.hpp"
#include "drivers/format/yaml_lines.hpp"
#include "drivers/format/yaml_reader.hpp"
#include "drivers/material/registry.hpp"
#include "drivers/material/source_description.hpp"
#include "drivers/scene/material_path.hpp"
#include "drivers/scene/scene_reader.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/system/terminal.hpp"
#include "drivers/text/numbers.hpp"

namespace assay::drivers {

namespace {

/// A scene is a YAML file that has a motion; a description of a material has none.
bool is_scene(const std::string& material) {
  const MaterialName name = parse_material(material);
  const bool is_yaml =
      name.is_path && name.table.empty() && (name.file.ends_with(".yaml") || name.file.ends_with(".yml"));
  const std::string& file = is_stream(material) ? material : name.file;
  return (is_stream(material) || is_yaml) && read_yaml(read_bytes(file), file).find("motion");
}

}  // namespace

std::map<std::string, double> parameters_in(const std::string& list) {
  std::map<std::string, double> parameters;
  for (std::size_t begin = 0; begin < list.size() || (begin > 0 && list.back() == ',');) {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    const std::string item = list.substr(begin, end - begin);
    const std::size_t equals = item.find('=');
    const std::string text = equals == item.npos ? "" : item.substr(equals + 1);
    const auto value = parse_number(stripped(text));
    const std::string name(stripped(std::string_view(item).substr(0, equals)));
    if (!value || name.empty()) {
      throw InputError({}, "--parameters",
                       "must be NAME=NUMBER, separated by commas, found '" + one_line(item, 60) + "'" +
                           (equals != item.npos  ? number_remedy(text)
                            : parse_number(item) ? ": a comma separates parameters, not digits"
                                                 : std::string()));
    }
    if (!parameters.emplace(name, *value).second)
      throw InputError({}, "--parameters", "'" + one_line(name, 60) + "' is given twice");
    begin = end + 1;
  }
  return parameters;
}

ResolvedMaterial material_to_check(const CheckOptions& options) {
  MaterialChoice choice;
  std::optional<std::vector<std::string>> of_source;  ///< warnings, which have been told
  if (is_scene(options.material)) {
    choice = read_scene(options.material).material;
  } else if (asks_for_source(options.material)) {
    SourceRequest request = request_of(options.source);
    request.needs_values = options.parameters.empty();
    request.least_properties = numbered_parameters(parameters_in(options.parameters));
    DescribedSource described = described_source(options.material, request, options.out, options.verbosity);
    choice.adapter = described.file;
    of_source = std::move(described.warnings);
  } else {
    choice.adapter = absolute_material(options.material, {});  // the process that tests it stands elsewhere
  }
  choice.parameters_option = "--parameters";
  if (choice.where.file.empty()) choice.adapter_key = {}, choice.parameters_key = "parameters";
  if (!asks_for_source(options.material)) refuse_source_options(options.source, options.material);
  for (const auto& [name, value] : parameters_in(options.parameters)) {
    choice.parameters[name] = value;
    choice.parameter_where[name] = {choice.parameters_option, 0, 0};
    choice.parameter_key_where.erase(name);
  }
  if (!(choice.density > 0)) choice.density = 1;  // no test needs one
  choice.isolation = Isolation::worker;           // nobody's code runs in this process
  ResolvedMaterial resolved = resolve_material(choice, Example::where_required);
  if (of_source) {
    resolved.warnings = *of_source;
  } else {
    for (const std::string& warning : resolved.warnings) warn(warning);
  }
  if (!resolved.library.empty()) hash_of_library(resolved.library);  // a model may leave no file that can be opened
  return resolved;
}

ResolvedMaterial registered_material(const std::string& name, const std::map<std::string, double>& given) {
  const MaterialSource source = find_material(name, {}, "", Isolation::none);
  MaterialChoice choice;
  choice.adapter = name;
  choice.isolation = Isolation::none;  // it is called in a process that may die
  choice.density = source.density.value_or(1);
  for (std::uint32_t i = 0; i < source.table->parameter_count; ++i) {
    const auto found = given.find(source.table->parameters[i].name);
    if (found != given.end()) choice.parameters.insert(*found);
  }
  return resolve_material(choice, Example::all);
}

}  // namespace assay::drivers
