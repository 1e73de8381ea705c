// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/check/replay.hpp"

#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <span>

#include "drivers/check/check_material.hpp"
#include "drivers/format/number_slips.hpp"
#include "drivers/format/yaml_reader.hpp"
#include "drivers/format/yaml_values.hpp"
#include "drivers/format/yaml_writer.hpp"
#include "drivers/scene/material_path.hpp"
#include "drivers/system/environment.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/sha256.hpp"
#include "harness/material/state_variable.hpp"

namespace assay::drivers {

namespace {

std::string line_of(const std::string& key, const std::string& value) { return key + ": " + value + "\n"; }

std::string list_of(std::span<const double> numbers) { return "[" + joined(numbers, yaml_number) + "]"; }

std::string tensor_text(const Tensor& F) {
  std::vector<std::string> rows;
  for (int row = 0; row < 3; ++row) rows.push_back(list_of(std::array{F(row, 0), F(row, 1), F(row, 2)}));
  return "[" + joined(rows) + "]";
}

std::string step_text(const assay_material& table, const FailedStep& step) {
  std::string text = line_of("t", yaml_number(step.t)) + line_of("dt", yaml_number(step.dt)) +
                     line_of("F0", tensor_text(step.F0)) + line_of("F1", tensor_text(step.F1)) +
                     (table.state_count == 0 ? "state0: {}\n" : "state0:\n");
  for (const StatePlace& place : assay::state_of(table)) {
    const auto values = std::span(step.state0).subspan(place.first, place.size);
    text += "  " + line_of(yaml_scalar(place.name), place.size == 1 ? yaml_number(values[0]) : list_of(values));
  }
  if (step.fields1.empty()) return text;
  text += "fields1:\n";
  std::size_t k = 0;
  for (const StatePlace& place : assay::state_of(table)) {
    if (place.role == ASSAY_ROLE_FIELD)
      text += "  " + line_of(yaml_scalar(place.name), yaml_number(step.fields1.at(k++)));
  }
  return text;
}

std::string test_text(const Replay& replay) {
  const check::Effort &effort = replay.effort, usual;
  std::string text = line_of("test", yaml_scalar(replay.test)) + line_of("quick", effort.quick ? "true" : "false");
  if (effort.strain != usual.strain) text += line_of("strain", yaml_number(effort.strain));
  if (effort.strain_is_asked) text += line_of("strain_is_asked", "true");
  if (effort.step != usual.step) text += line_of("step", yaml_number(effort.step));
  if (replay.rate_dependent) text += line_of("rate_dependent", "true");
  if (effort.pressure) text += line_of("pressure", yaml_number(*effort.pressure));
  return text;
}

/// Of the numbers in a replay: those of the user's parameters, unless the description says what these are.
std::string units_words(const ResolvedMaterial& resolved) {
  if (resolved.foreign) {
    const adapters::ModelUnits& units = resolved.foreign->units;
    const bool said = units.stress != 1 || units.time != 1 || units.length != 1;
    return said ? "Times in s, stresses in Pa, STATEV in the model's own units."
                : "Times and stresses in the units that the parameters imply.";
  }
  const assay_material& table = resolved.material.table();
  for (std::uint32_t i = 0; i < table.parameter_count; ++i) {
    const std::string unit = table.parameters[i].unit ? table.parameters[i].unit : "";
    if (unit.ends_with("Pa")) return "Times in s, stresses in " + one_line(unit, 20) + ", as the parameters.";
  }
  return "Times in s, stresses in the unit of the parameters.";
}

const Tree& required(const Tree& map, const std::string& prefix, const std::string& key) {
  const Tree* found = map.find(key);
  if (!found) throw InputError(map.where, key_path(prefix, key), "required and not given");
  return *found;
}

double any_number(const Tree& tree, const std::string& key) {
  const auto value = tree.kind == Tree::Kind::scalar ? parse_number(tree.text) : std::nullopt;
  if (!value) throw InputError(tree.where, key, "must be a number, found " + described(tree) + number_remedy(tree));
  return *value;
}

void append_numbers(const Tree& tree, const std::string& key, std::size_t count, std::vector<double>& out) {
  if (count == 1 && tree.kind == Tree::Kind::scalar) {
    out.push_back(any_number(tree, key));
    return;
  }
  if (tree.kind != Tree::Kind::sequence || tree.items.size() != count)
    throw InputError(tree.where, key, "must be a list of " + std::to_string(count) + ", found " + described(tree));
  for (const Tree& item : tree.items) out.push_back(any_number(item, key));
}

Tensor tensor_of(const Tree& root, const std::string& key) {
  const Tree& tree = required(root, "", key);
  if (tree.kind != Tree::Kind::sequence || tree.items.size() != 3)
    throw InputError(tree.where, key, "must be three rows, found " + described(tree));
  std::vector<double> values;
  for (const Tree& row : tree.items) append_numbers(row, key, 3, values);
  Tensor F;
  for (int c = 0; c < 9; ++c) component(F, c) = values[static_cast<std::size_t>(c)];
  return F;
}

/// Of the map under that key, one after the other.
std::vector<double> values_of(const Tree& root, const std::string& key, const std::vector<StatePlace>& places) {
  const Tree& tree = required(root, "", key);
  std::vector<double> values;
  const std::vector<std::string> names =
      mapped(places, [](const StatePlace& place) { return std::string(place.name); });
  require_map(tree, key, joined(names));
  refuse_unknown_keys(tree, key, names);
  for (const StatePlace& place : places)
    append_numbers(required(tree, key, place.name), key_path(key, place.name), place.size, values);
  return values;
}

FailedStep step_of(const Tree& root, const assay_material& table) {
  FailedStep step;
  step.t = any_number(required(root, "", "t"), "t");
  step.dt = any_number(required(root, "", "dt"), "dt");
  if (!(step.dt > 0)) throw InputError(required(root, "", "dt").where, "dt", "must be above 0");
  step.F0 = tensor_of(root, "F0");
  step.F1 = tensor_of(root, "F1");
  std::vector<StatePlace> places = assay::state_of(table);
  step.state0 = values_of(root, "state0", places);
  std::erase_if(places, [](const StatePlace& place) { return place.role != ASSAY_ROLE_FIELD; });
  if (root.find("fields1")) step.fields1 = values_of(root, "fields1", places);
  return step;
}

}  // namespace

std::string hash_of_library(const std::string& file) {
  constexpr std::size_t largest_library = std::size_t{4} << 30;
  static std::mutex guard;
  static std::map<std::string, std::string> known;
  const std::lock_guard lock(guard);
  std::error_code code;
  const auto time = std::filesystem::last_write_time(file, code).time_since_epoch().count();
  std::string& hash =
      known[file + '\n' + std::to_string(time) + '\n' + std::to_string(std::filesystem::file_size(file, code))];
  if (hash.empty()) hash = sha256_hex(read_bytes(file, largest_library));
  return hash;
}

Replay replay_of(const ResolvedMaterial& resolved, const std::optional<FailedStep>& step, const std::string& reason) {
  Replay replay{resolved.choice.adapter, resolved.choice.parameters, {}, step, reason, resolved.choice.varying};
  if (!resolved.library.empty()) {
    replay.material =
        resolved.description.empty() ? resolved.library + ":" + resolved.material.name() : resolved.description;
    replay.library_sha256 = hash_of_library(resolved.library);
    // The description of a source that has none is kept in the cache, from which it may go.
    if (resolved.choice.adapter == resolved.source) replay.material = resolved.source;
  }
  return replay;
}

std::string replay_yaml(const Replay& replay, Isolation isolation) {
  const ResolvedMaterial resolved = resolved_of(replay, isolation);
  const Material& material = resolved.material;
  const bool has_fields = replay.step && !replay.step->fields1.empty();
  std::string text = (replay.step ? std::string("# A step that a material failed: F0 and state0 at t, F1") +
                                        (has_fields ? " and fields1" : "") + " at t + dt."
                                  : "# A test that a material failed, in many steps.") +
                     " To repeat it: assay check --replay\n# " + units_words(resolved) + "\n";
  text += line_of("material", yaml_scalar(replay.material));
  std::string folders;  // in which a description finds its library
  for (const std::string& folder : material_folders()) folders += (folders.empty() ? "" : ":") + folder;
  if (!resolved.description.empty() && !folders.empty()) text += line_of("material_path", yaml_scalar(folders));
  text += replay.parameters.empty() ? "parameters: {}\n" : "parameters:\n";
  for (const auto& [name, value] : replay.parameters) text += "  " + line_of(yaml_scalar(name), yaml_number(value));
  text += line_of("library_sha256", replay.library_sha256.empty() ? "null" : yaml_scalar(replay.library_sha256));
  if (!replay.test.empty()) text += test_text(replay);
  if (replay.step) text += step_text(material.table(), *replay.step);
  return text + line_of("reason", yaml_scalar(one_line(replay.reason)));
}

Replay read_replay(const std::string& file, Isolation isolation, const std::string& material) {
  const Tree root = read_yaml(read_bytes(file), file);
  const std::vector<std::string> known{
      "material",       "parameters",   "library_sha256", "t",     "dt",     "F0",   "F1",       "state0",
      "fields1",        "reason",       "test",           "quick", "strain", "step", "pressure", "strain_is_asked",
      "rate_dependent", "material_path"};
  require_map(root, "", joined(known));
  refuse_other_kind(root, FileKind::replay);
  refuse_unknown_keys(root, "", known);
  Replay replay;
  replay.material = text_value(required(root, "", "material"), "material");
  replay.where = required(root, "", "material").where;
  if (!material.empty()) replay.material = material, replay.where = {};
  const Tree* folders = root.find("material_path");
  if (folders && material_folders().empty())
    ::setenv("ASSAY_MATERIAL_PATH", text_value(*folders, "material_path").c_str(), 1);
  const Tree& parameters = required(root, "", "parameters");
  require_map(parameters, "parameters", "the parameters of the material");
  for (const Tree::Entry& entry : parameters.entries)
    replay.parameters[entry.key] = number_value(entry.value, "parameters." + one_line(entry.key, 80));
  if (const Tree* fields = root.find("fields1")) {
    require_map(*fields, "fields1", "the fields of the material");
    for (const Tree::Entry& entry : fields->entries) replay.varying.push_back(entry.key);
  }
  const auto number = [&root](const char* key, auto& value) {
    if (const Tree* found = root.find(key)) value = number_value(*found, key);
  };
  const auto truth = [&root](const char* key, bool& value) {
    if (const Tree* found = root.find(key)) value = boolean_value(*found, key);
  };
  const Tree* hash = root.find("library_sha256");
  if (hash && hash->kind == Tree::Kind::scalar) replay.library_sha256 = hash->text;
  if (const Tree* test = root.find("test"))
    replay.test = choice_value(*test, "test", tests_of_check(), "`assay check --verbose`");
  truth("quick", replay.effort.quick);
  number("strain", replay.effort.strain);
  truth("strain_is_asked", replay.effort.strain_is_asked);
  truth("rate_dependent", replay.rate_dependent);
  number("step", replay.effort.step);
  number("pressure", replay.effort.pressure);
  if (replay.test.empty() || root.find("t"))
    replay.step = step_of(root, resolved_of(replay, isolation).material.table());
  if (const Tree* reason = root.find("reason")) replay.reason = text_value(*reason, "reason");
  return replay;
}

ResolvedMaterial resolved_of(const Replay& replay, Isolation isolation) {
  MaterialChoice choice;
  choice.isolation = isolation;
  choice.adapter = replay.material;
  choice.parameters = replay.parameters;
  choice.varying = replay.varying;
  choice.density = 1;  // a replay needs none
  choice.where = replay.where;
  choice.adapter_key = "material", choice.parameters_key = "parameters";
  return resolve_material(choice);
}

}  // namespace assay::drivers
