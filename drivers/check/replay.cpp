// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/check/replay.hpp"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <mutex>

#include "drivers/check/check_beyond.hpp"
#include "drivers/check/check_host.hpp"
#include "drivers/check/check_material.hpp"
#include "drivers/check/check_vortex.hpp"
#include "drivers/format/file_kind.hpp"
#include "drivers/format/number_slips.hpp"
#include "drivers/format/yaml_reader.hpp"
#include "drivers/format/yaml_values.hpp"
#include "drivers/format/yaml_writer.hpp"
#include "drivers/material/material_choice.hpp"
#include "drivers/material/registry.hpp"
#include "drivers/scene/material_path.hpp"
#include "drivers/system/environment.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/sha256.hpp"
#include "harness/motion/kinds/deformation_table.hpp"

namespace assay::drivers {

namespace {

template <class Value>
std::string list_text(int count, const Value& value) {
  std::string text;
  for (int i = 0; i < count; ++i) text += (i ? ", " : "") + yaml_number(value(i));
  return "[" + text + "]";
}

std::string tensor_text(const Tensor& F) {
  std::string text;
  for (int row = 0; row < 3; ++row) text += (row ? ", " : "") + list_text(3, [&](int c) { return F(row, c); });
  return "[" + text + "]";
}

std::string state_text(const assay_material& table, const std::vector<double>& state) {
  if (table.state_count == 0) return "state0: {}\n";
  std::string text = "state0:\n";
  std::size_t at = 0;
  for (std::uint32_t i = 0; i < table.state_count; ++i) {
    const int count = components_of_kind(table.state[i].kind);
    const auto value = [&](int c) { return state[at + static_cast<std::size_t>(c)]; };
    text += "  " + yaml_scalar(table.state[i].name) + ": " +
            (count == 1 ? yaml_number(value(0)) : list_text(count, value)) + "\n";
    at += static_cast<std::size_t>(count);
  }
  return text;
}

std::string step_text(const assay_material& table, const FailedStep& step) {
  return "t: " + yaml_number(step.t) + "\ndt: " + yaml_number(step.dt) + "\n" + "F0: " + tensor_text(step.F0) +
         "\nF1: " + tensor_text(step.F1) + "\n" + state_text(table, step.state0);
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
  if (tree.kind != Tree::Kind::sequence || tree.items.size() != count) {
    throw InputError(tree.where, key, "must be a list of " + std::to_string(count) + ", found " + described(tree));
  }
  for (const Tree& item : tree.items) out.push_back(any_number(item, key));
}

Tensor tensor_of(const Tree& root, const std::string& key) {
  const Tree& tree = required(root, "", key);
  if (tree.kind != Tree::Kind::sequence || tree.items.size() != 3) {
    throw InputError(tree.where, key, "must be three rows, found " + described(tree));
  }
  std::vector<double> values;
  for (const Tree& row : tree.items) append_numbers(row, key, 3, values);
  Tensor F;
  for (int c = 0; c < 9; ++c) component(F, c) = values[static_cast<std::size_t>(c)];
  return F;
}

std::vector<double> state_of(const Tree& root, const assay_material& table) {
  const Tree& tree = required(root, "", "state0");
  std::vector<double> state;
  std::vector<std::string> names;
  for (std::uint32_t i = 0; i < table.state_count; ++i) names.emplace_back(table.state[i].name);
  require_map(tree, "state0", joined(names));
  refuse_unknown_keys(tree, "state0", names);
  for (std::uint32_t i = 0; i < table.state_count; ++i) {
    append_numbers(required(tree, "state0", names[i]), "state0." + names[i],
                   static_cast<std::size_t>(components_of_kind(table.state[i].kind)), state);
  }
  return state;
}

FailedStep step_of(const Tree& root, const assay_material& table) {
  FailedStep step;
  step.t = any_number(required(root, "", "t"), "t");
  step.dt = any_number(required(root, "", "dt"), "dt");
  if (!(step.dt > 0)) throw InputError(required(root, "", "dt").where, "dt", "must be above 0");
  step.F0 = tensor_of(root, "F0");
  step.F1 = tensor_of(root, "F1");
  step.state0 = state_of(root, table);
  return step;
}

}  // namespace

Replay replay_of(const Scene& scene, const FailedStep& step, const std::string& reason) {
  return replay_of(resolve_material(scene.material), step, reason);
}

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
  Replay replay{resolved.choice.adapter, resolved.choice.parameters, {}, step, reason};
  if (!resolved.library.empty()) {
    replay.material =
        resolved.description.empty() ? resolved.library + ":" + resolved.material.name() : resolved.description;
    replay.library_sha256 = hash_of_library(resolved.library);
    // The description of a source that has none is kept in the cache, from which it may go.
    if (resolved.choice.adapter == resolved.source) replay.material = resolved.source;
  }
  return replay;
}

namespace {

std::string test_text(const Replay& replay) {
  std::string text =
      "test: " + yaml_scalar(replay.test) + "\nquick: " + (replay.effort.quick ? "true" : "false") + "\n";
  if (replay.effort.strain != check::Effort{}.strain) text += "strain: " + yaml_number(replay.effort.strain) + "\n";
  if (replay.effort.strain_is_asked) text += "strain_is_asked: true\n";
  if (replay.effort.step != check::Effort{}.step) text += "step: " + yaml_number(replay.effort.step) + "\n";
  if (replay.rate_dependent) text += "rate_dependent: true\n";
  if (replay.effort.pressure) text += "pressure: " + yaml_number(*replay.effort.pressure) + "\n";
  return text;
}

}  // namespace

namespace {

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

}  // namespace

std::string replay_yaml(const Replay& replay, Isolation isolation) {
  const ResolvedMaterial resolved = resolved_of(replay, isolation);
  const Material& material = resolved.material;
  std::string text = std::string(replay.step ? "# A step that a material failed: F0 and state0 at t, F1 at t + dt."
                                             : "# A test that a material failed, in many steps.") +
                     " To repeat it: assay check --replay\n# " + units_words(resolved) + "\n";
  text += "material: " + yaml_scalar(replay.material) + "\n";
  std::string folders;  // in which a description finds its library
  for (const std::string& folder : material_folders()) folders += (folders.empty() ? "" : ":") + folder;
  if (!resolved.description.empty() && !folders.empty()) text += "material_path: " + yaml_scalar(folders) + "\n";
  text += "parameters:";
  if (replay.parameters.empty()) text += " {}";
  text += "\n";
  for (const auto& [name, value] : replay.parameters)
    text += "  " + yaml_scalar(name) + ": " + yaml_number(value) + "\n";
  text += "library_sha256: " + (replay.library_sha256.empty() ? "null" : yaml_scalar(replay.library_sha256)) + "\n";
  if (!replay.test.empty()) text += test_text(replay);
  if (replay.step) text += step_text(material.table(), *replay.step);
  return text + "reason: " + yaml_scalar(one_line(replay.reason)) + "\n";
}

namespace {

std::vector<std::string> tests_of_check() {
  std::vector<std::string> ids = check::test_ids();
  for (const char* own : {process_test, vortex_test, beyond_test, host_test}) ids.emplace_back(own);
  return ids;
}

}  // namespace

Replay read_replay(const std::string& file, Isolation isolation, const std::string& material) {
  const Tree root = read_yaml(read_bytes(file), file);
  const std::vector<std::string> known{
      "material",        "parameters",     "library_sha256", "t",     "dt",     "F0",   "F1",
      "state0",          "reason",         "test",           "quick", "strain", "step", "pressure",
      "strain_is_asked", "rate_dependent", "material_path"};
  require_map(root, "", joined(known));
  refuse_other_kind(root, FileKind::replay);
  refuse_unknown_keys(root, "", known);
  Replay replay;
  replay.material = text_value(required(root, "", "material"), "material");
  replay.where = required(root, "", "material").where;
  if (!material.empty()) replay.material = material, replay.where = {};
  const Tree* folders = root.find("material_path");
  if (folders && material_folders().empty()) {
    ::setenv("ASSAY_MATERIAL_PATH", text_value(*folders, "material_path").c_str(), 1);
  }
  const Tree& parameters = required(root, "", "parameters");
  require_map(parameters, "parameters", "the parameters of the material");
  for (const Tree::Entry& entry : parameters.entries) {
    replay.parameters[entry.key] = number_value(entry.value, "parameters." + one_line(entry.key, 80));
  }
  const Tree* hash = root.find("library_sha256");
  if (hash && hash->kind == Tree::Kind::scalar) replay.library_sha256 = hash->text;
  if (const Tree* test = root.find("test"))
    replay.test = choice_value(*test, "test", tests_of_check(), "`assay check --verbose`");
  if (const Tree* quick = root.find("quick")) replay.effort.quick = boolean_value(*quick, "quick");
  if (const Tree* strain = root.find("strain")) replay.effort.strain = number_value(*strain, "strain");
  if (const Tree* asked = root.find("strain_is_asked")) {
    replay.effort.strain_is_asked = boolean_value(*asked, "strain_is_asked");
  }
  if (const Tree* rate = root.find("rate_dependent")) replay.rate_dependent = boolean_value(*rate, "rate_dependent");
  if (const Tree* step = root.find("step")) replay.effort.step = number_value(*step, "step");
  if (const Tree* pressure = root.find("pressure")) replay.effort.pressure = number_value(*pressure, "pressure");
  if (replay.test.empty() || root.find("t")) replay.step = step_of(root, material_of(replay, isolation).table());
  if (const Tree* reason = root.find("reason")) replay.reason = text_value(*reason, "reason");
  return replay;
}

Material material_of(const Replay& replay, Isolation isolation) {
  return std::move(resolved_of(replay, isolation).material);
}

ResolvedMaterial resolved_of(const Replay& replay, Isolation isolation) {
  MaterialChoice choice;
  choice.isolation = isolation;
  choice.adapter = replay.material;
  choice.parameters = replay.parameters;
  choice.density = 1;  // a replay needs none
  choice.where = replay.where;
  choice.adapter_key = "material", choice.parameters_key = "parameters";
  return resolve_material(choice);
}

std::string replay_hint(const Scene& scene, const std::vector<std::string>& sets, double end) {
  std::string command = "assay tabulate " + scene.file;
  // tabulate takes another function between the rows unless it is told
  const bool table = scene.motion.as<DeformationTable>();
  if (table && !scene.places.contains("motion.interpolation")) command += " --set motion.interpolation=monotone";
  for (const std::string& set : sets) command += " --set '" + set + "'";
  return "`" + command + " --set time.end=" + yaml_number(end) + "` leaves the step in a replay.yaml";
}

}  // namespace assay::drivers
