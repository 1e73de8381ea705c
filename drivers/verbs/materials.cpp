// SPDX-License-Identifier: BSD-3-Clause
// `assay materials`: what is registered, for people (80 columns) and for machines.
#include "drivers/verbs/verbs.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "drivers/command_line/verb.hpp"
#include "drivers/material/material_text.hpp"
#include "drivers/material/registry.hpp"
#include "drivers/result/json_figure.hpp"
#include "drivers/scene/material_path.hpp"
#include "drivers/system/terminal.hpp"

namespace assay::drivers {

namespace {

using Json = nlohmann::ordered_json;

Json text(const char* value) { return value ? Json(value) : Json(nullptr); }

Json parameters_json(const MaterialSource& source) {
  Json list = Json::array();
  for (const assay_parameter& p : parameters_of(*source.table)) {
    const auto own = source.parameters.find(p.name);
    list.push_back({{"name", text(p.name)},
                    {"unit", text(p.unit)},
                    {"default", json_figure(own == source.parameters.end() ? p.default_value : own->second)},
                    {"lower", json_figure(p.lower)},
                    {"upper", json_figure(p.upper)},
                    {"doc", text(p.doc)}});
  }
  return list;
}

Json state_json(const assay_material& table) {
  Json list = Json::array();
  for (const assay_state_variable& v : state_variables_of(table)) {
    list.push_back({{"name", text(v.name)},
                    {"unit", text(v.unit)},
                    {"kind", kind_name(v.kind)},
                    {"role", role_name(v.role)},
                    {"doc", text(v.doc)}});
  }
  return list;
}

Json material_json(const std::string& name, const MaterialSource& source) {
  const assay_material& table = *source.table;
  Json out;
  out["name"] = name;
  out["model"] = text(table.name);
  out["version"] = text(table.version);
  out["licence"] = text(table.licence);
  out["doc"] = text(table.doc);
  out["library"] = source.library.empty() ? "built-in" : source.library;
  if (!source.source.empty()) out["source"] = source.source;
  out["description"] = json_text(source.description);
  out["density"] = json_figure(source.density);
  out["flags"] = flag_names(table);
  out["parameters"] = parameters_json(source);
  out["state"] = state_json(table);
  return out;
}

Act add_materials_arguments(VerbArguments& verb) {
  const auto given = std::make_shared<MaterialsOptions>();
  add_value(verb, "NAME", given->name, "", "name, library, description or source", "@materials */ " + material_files);
  auto* json = verb.app.add_flag("--json", given->json, "as JSON");
  verb.app.add_flag("--names", given->names, "the names alone, one a line")->excludes(json);
  return [given](Verbosity verbosity) {
    if (given->names && !given->name.empty())
      throw InputError("assay materials: --names lists all names and takes no NAME");
    given->verbosity = verbosity;
    return materials(*given);
  };
}

}  // namespace

int materials(const MaterialsOptions& options) {
  const bool is_one = !options.name.empty();
  const std::vector<RegisteredName> names = is_one ? std::vector<RegisteredName>{} : registered_names();
  std::string page;
  std::size_t width = 0;
  for (const RegisteredName& registered : names) {
    width = std::max(width, registered.name.size());
    if (options.names) page += registered.name + "\n";
  }
  if (options.names) return print(page), 0;
  Json list = Json::array();
  const bool a_line_each = !is_one && options.verbosity != Verbosity::verbose;
  const auto add = [&](const std::string& name, const MaterialSource& source) {
    list.push_back(material_json(name, source));
    page += a_line_each ? material_line(name, source, width) : (page.empty() ? "" : "\n") + material_text(name, source);
  };
  if (is_one) {
    const MaterialSource source = find_material(options.name, {}, "", Isolation::worker);
    for (const std::string& warning : source.warnings) warn(warning);
    add(parse_material(options.name).is_path ? source.table->name : options.name, source);
  }
  for (const RegisteredName& registered : names) {
    const auto add_broken = [&](const char* reason) {  // one broken entry must not hide the others
      list.push_back({{"name", registered.name}, {"broken", reason}});
      page += (a_line_each ? "" : "\n") + broken_text(registered.name, reason);
    };
    try {
      add(registered.name, find_material(registered.name, {registered.file, 0, 0}, "", Isolation::worker));
    } catch (const InputError& error) {
      add_broken(error.what());
    } catch (const SystemError& error) {  // as of a source where there is no compiler
      add_broken(error.what());
    }
  }
  if (a_line_each && options.verbosity != Verbosity::quiet)
    page += "\nassay materials NAME shows parameters, units, bounds and state.\n";
  if (options.json)
    print_json((is_one ? list[0] : list).dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
  else
    print(page);
  return 0;
}

Verb verb_materials() {
  return {20, "list the materials, or show one",
          "assay materials neo_hookean\n  assay materials ./libmodel.so:name --json", add_materials_arguments};
}

}  // namespace assay::drivers
