// SPDX-License-Identifier: BSD-3-Clause
// `assay register`: a library or a description of one becomes a name in the user's registry.
#include "drivers/verbs/verbs.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <system_error>

#include "adapters/builtin.hpp"
#include "adapters/foreign/foreign_state.hpp"
#include "adapters/worker/probe.hpp"
#include "drivers/command_line/verb.hpp"
#include "drivers/format/yaml_lines.hpp"
#include "drivers/material/abaqus_deck.hpp"
#include "drivers/material/foreign_description.hpp"
#include "drivers/material/fortran_compiler.hpp"
#include "drivers/material/material_description.hpp"
#include "drivers/material/material_text.hpp"
#include "drivers/material/registry.hpp"
#include "drivers/material/source_description.hpp"
#include "drivers/scene/material_path.hpp"
#include "drivers/system/environment.hpp"
#include "drivers/system/input_error.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/system/terminal.hpp"
#include "drivers/system/whole_file.hpp"
#include "drivers/text/wrapped_text.hpp"

namespace assay::drivers {

namespace fs = std::filesystem;

namespace {

std::string folder() {
  std::string found = registry_folder();
  if (found.empty())
    throw SystemError("there is no registry: none of ASSAY_DATA_HOME, XDG_DATA_HOME, HOME leads to one");
  return found;
}

int remove_name(const std::string& name) {
  std::vector<std::string> known;
  for (const auto& [registered, file] : registered_names()) {
    if (!file.empty() && fs::path(file).parent_path() == folder()) known.push_back(registered);
  }
  if (adapters::builtin_table(name)) throw InputError({}, "--remove", "'" + name + "' is built in");
  const fs::path file = fs::path(folder()) / (name + ".yaml");
  std::error_code code;
  const fs::file_status there = fs::symlink_status(file, code);
  if (!is_material_name(name) || !fs::exists(there))
    throw InputError({}, "--remove", unknown("name '" + name + "'", name, known),
                     known.empty() ? "none" : joined(known));
  if (fs::is_directory(there))
    throw InputError({}, "--remove", "'" + file.string() + "' is a folder and no registered name");
  fs::remove(file, code);  // which may be gone by now: somebody else has done the same
  if (code) throw SystemError("'" + file.string() + "' cannot be removed: " + code.message());
  return 0;
}

/// What will be written: the file's own words with absolute paths, and the table's name said.
MaterialDescription description_of(const std::string& file, const MaterialSource& source) {
  const MaterialName asked = parse_material(file);
  MaterialDescription description =
      source.description.empty() ? description_of_library(source.library, asked.table, {}, "") : read_description(file);
  description.library = source.library;
  description.name = source.table->name;
  return description;
}

/// Parameters that a scene must give.
std::vector<std::string> names_without_value(const MaterialSource& source) {
  std::vector<std::string> names;
  for (const assay_parameter& p : parameters_of(*source.table)) {
    if (std::isnan(p.default_value) && source.parameters.count(p.name) == 0) names.push_back(p.name);
  }
  return names;
}

/// "3 state variables of 8 numbers", as its author counts them: those of the bridge and fields are none.
std::string own_state_words(const MaterialSource& source, const adapters::ForeignModel& model) {
  const std::span all = state_variables_of(*source.table);
  const std::size_t before = adapters::bridge_state(model).size();
  const auto own = all.subspan(before, all.size() - before - model.varying.size());
  std::size_t size = 0;
  for (const assay_state_variable& v : own) size += static_cast<std::size_t>(components_of_kind(v.kind));
  const std::string words = std::to_string(own.size()) + " state variables";
  return size == own.size() ? words : words + " of " + std::to_string(size) + " numbers";
}

/// What was found of a foreign model, and what is missing.
std::string notes(const MaterialSource& source, const MaterialDescription& description) {
  std::string page;
  const auto note = [&](const std::string& text) { page += wrapped(text, "  ", "    "); };
  const std::vector<std::string> missing = names_without_value(source);
  if (description.foreign) {
    const auto interface = static_cast<std::size_t>(description.foreign->interface) + 1;
    note(interface_names()[interface] + ", " + description.foreign->symbol + ": " +
         std::to_string(source.table->parameter_count) + " properties, " +
         own_state_words(source, *description.foreign) + "; runs in processes of its own");
    if (!missing.empty()) note("not tried: scenes, or a description, must give " + joined(missing));
    if (!source.density) note("scenes must give its density");
  }
  if (!(source.table->flags & ASSAY_RATE_DEPENDENT) && missing.empty() &&
      adapters::depends_on_duration(source.table, source.parameters)) {
    note(
        "the stress depends on the length of a step, but the model does not declare it: declare the model "
        "rate-dependent (flags: [rate_dependent] in a description), or find out what it does with the time");
  }
  return page;
}

std::string chosen_name(const RegisterOptions& options, const MaterialSource& source) {
  std::string name = options.name;
  const bool has_file = !source.description.empty() && !is_stream(options.file);
  if (name.empty()) name = !has_file ? source.table->name : fs::path(options.file).stem().string();
  const std::string key = options.name.empty() ? options.file : "--as";
  if (!is_material_name(name))
    throw InputError({}, key,
                     "'" + name + "' is no name: letters, digits, '_', '-' and '.', not ending as a path does");
  if (adapters::builtin_table(name))
    throw InputError({}, key, "'" + name + "' is the name of a built-in material; choose another with --as");
  return name;
}

/// The registry is YAML, which holds text and no other bytes.
void refuse_what_is_no_text(const std::string& path) {
  const bool control = std::ranges::any_of(path, [](unsigned char c) { return c < 0x20 || c == 0x7f; });
  if (control) throw InputError({}, "FILE", "its path has control characters, which the registry cannot store");
  try {
    check_text(path, "FILE", path.size());
  } catch (const InputError&) {
    throw InputError({}, "FILE", "its path is not UTF-8 text, and the registry can keep no other");
  }
}

/// What is to be registered.
struct Candidate {
  MaterialSource source;
  MaterialDescription description;
  std::string text;                ///< that the registry keeps
  std::vector<std::string> notes;  ///< of a Fortran source: what was taken and guessed
  std::vector<std::string> warnings;
};

Candidate candidate_of_source(const std::string& path, const std::string& chosen, const SourceOptions& options) {
  SourceRequest request = request_of(options);
  std::string& choice = is_deck(path) ? request.material : request.symbol;
  if (choice.empty()) choice = chosen;
  const SourceDescription described = describe_source(path, request, {}, "");
  const std::string file = kept_description(described.name, described.text);
  Candidate candidate{
      find_material(file, {}, "", Isolation::worker), {}, described.text, described.notes, described.warnings};
  candidate.description = description_of(file, candidate.source);
  return candidate;
}

Candidate candidate_of(const RegisterOptions& options) {
  const MaterialName asked = parse_material(options.file);
  // A bare name means a file here, not a registered one.
  const std::string path = is_stream(asked.file) ? asked.file : absolute_path(asked.file);
  refuse_what_is_no_text(path);
  if (asks_for_source(options.file)) return candidate_of_source(path, asked.table, options.source);
  refuse_source_options(options.source, options.file);
  Candidate candidate;
  candidate.source = find_material(asked.table.empty() ? path : path + ":" + asked.table, {}, "", Isolation::worker);
  candidate.description = description_of(options.file, candidate.source);
  candidate.text = lasting_yaml(candidate.description);
  candidate.warnings = candidate.source.warnings;
  return candidate;
}

/// What it says of an undeformed point, where that is no reason to refuse it. Throws InputError where it is one.
std::optional<std::string> tried(const MaterialSource& source, const Location& where) {
  try {
    std::optional<std::string> defect = adapters::probe_defect(source.table, source.parameters);
    if (source.foreign && !names_without_value(source).empty()) defect.reset();
    if (defect && !defect->starts_with(adapters::refuses_rest))
      throw InputError(where, "", "material '" + std::string(source.table->name) + "' is refused: " + *defect);
    return defect;
  } catch (const std::system_error& error) {
    throw SystemError(std::string("the material cannot be probed: ") + error.what());
  }
}

std::string told(const std::string& name, const Candidate& candidate, bool replaces,
                 const std::optional<std::string>& defect) {
  const MaterialSource& source = candidate.source;
  std::string page = "registered " + name + ": " + source.table->name + " in " +
                     one_line(source.source.empty() ? source.library : source.source) +
                     (replaces ? "; replaces what had that name" : "") + "\n" + notes(source, candidate.description);
  if (defect) page += wrapped("it " + *defect, "  ", "    ");
  for (const std::string& note : candidate.notes) page += wrapped(note, "  ", "    ");
  return page;
}

Act add_register_arguments(VerbArguments& verb) {
  const auto given = std::make_shared<RegisterOptions>();
  auto* file = add_value(verb, "FILE", given->file, "", "library (or FILE.so:NAME), description or source",
                         "*/ " + material_files);
  auto* as = add_value(verb, "--as", given->name, "NAME", "the name (default: the material's own)");
  add_value(verb, "--remove", given->remove, "NAME", "remove a name from the registry")->excludes(file)->excludes(as);
  add_source_options(verb, given->source);
  return [given, file](Verbosity verbosity) {
    if (file->count() == 0 && given->remove.empty()) throw InputError("assay register: takes FILE or --remove NAME");
    if (file->count() > 0 && given->file.empty()) throw InputError("assay register: FILE is empty");
    given->verbosity = verbosity;
    return register_material(*given);
  };
}

}  // namespace

int register_material(const RegisterOptions& options) {
  if (!options.remove.empty()) {
    refuse_source_options(options.source, "");
    return remove_name(options.remove);
  }
  const Candidate candidate = candidate_of(options);
  refuse_what_is_no_text(candidate.source.library);
  const std::string name = chosen_name(options, candidate.source);
  const std::optional<std::string> defect = tried(candidate.source, {options.file, 0, 0});
  watch_interrupts();
  const fs::path file = fs::path(folder()) / (name + ".yaml");
  std::error_code code;
  fs::create_directories(folder(), code);
  if (code) throw SystemError("'" + folder() + "' cannot be made: " + code.message());
  const bool replaces = fs::exists(file, code);
  write_file(file, candidate.text);
  for (const std::string& warning : candidate.warnings) warn(warning);
  if (options.verbosity != Verbosity::quiet) print(told(name, candidate, replaces, defect));
  return 0;
}

Verb verb_register() {
  return {30, "give a material library or source a name",
          "assay register ./libmodel.so --as soft_clay\n  assay register --remove soft_clay", add_register_arguments};
}

}  // namespace assay::drivers
