// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/material_description.hpp"

#include <algorithm>

#include "adapters/elf_symbols.hpp"
#include "adapters/foreign/mfront_metadata.hpp"
#include "adapters/library.hpp"
#include "drivers/format/yaml_reader.hpp"
#include "drivers/format/yaml_values.hpp"
#include "drivers/format/yaml_writer.hpp"
#include "drivers/material/foreign_description.hpp"
#include "drivers/material/fortran_compiler.hpp"
#include "drivers/material/source_entry.hpp"
#include "drivers/scene/material_path.hpp"
#include "drivers/system/environment.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/text/unseen.hpp"
#include "drivers/text/words.hpp"

namespace assay::drivers {

namespace {

/// native, umat, ...
std::string interface_of(const Tree& root) {
  const Tree* tree = root.find("interface");
  return tree ? choice_value(*tree, "interface", interface_names()) : "native";
}

/// Whether it is one of a Fortran routine.
bool has_source(const std::string& interface) { return interface != "native" && interface != "mfront"; }

std::vector<std::string> keys_of(const std::string& interface) {
  std::vector<std::string> known{"library", "name", "interface", "density", "time_limit", "memory_limit", "files"};
  if (has_source(interface)) known.insert(known.begin() + 1, {"source", "link"});
  if (interface == "native") append_all(known, {"parameters"});
  for (const std::string& key : interface == "native" ? std::vector<std::string>() : foreign_keys()) {
    if (!is_one_of(key, keys_without_effect(interface))) known.push_back(key);
  }
  return known;
}

/// What would have no effect.
void refuse_keys_of_others(const Tree& root, const std::string& interface) {
  const bool is_said = root.find("interface") != nullptr;
  const Tree* source = root.find("source");
  if (source && !has_source(interface)) {
    throw InputError(source->where, "source",
                     "goes with interface: umat, vumat, usermat or lsdyna" +
                         (is_said ? ", found interface: " + interface : ": write one of these lines beside it"));
  }
  if (interface == "native") return;
  for (const std::string& key : keys_without_effect(interface)) {
    const Tree* tree = root.find(key);
    if (!tree) continue;
    std::vector<std::string> takers = interface_names();
    std::erase_if(takers, [&](const std::string& other) {
      return other == "native" || is_one_of(key, keys_without_effect(other));
    });
    throw InputError(tree->where, key, "has no effect with interface: " + interface + ", only with " + joined(takers));
  }
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

/// The words of a list or of one text, and where each stands.
std::vector<std::pair<std::string, Location>> read_link(const Tree& tree, const std::filesystem::path& folder) {
  const auto word = [&](const Tree& item) {
    return std::pair(linked_word(text_value(item, "link"), folder, item.where, "link"), item.where);
  };
  if (tree.kind != Tree::Kind::sequence) return {word(tree)};
  return mapped(tree.items, word);
}

/// A library, or a source that becomes one. With both the library is that of the source, as for a worker.
void read_library(const Tree& root, const std::string& interface, const std::filesystem::path& folder,
                  MaterialDescription& description) {
  const Tree *library = root.find("library"), *source = root.find("source");
  if (!library && !source)
    throw InputError(root.where, "library", "required and not given", joined(keys_of(interface)));
  const Tree& named = library ? *library : *source;
  description.library_where = description.name_where = named.where;
  if (source && source->kind == Tree::Kind::sequence) {
    throw InputError(
        source->where, "source",
        "must be one file, found a list: let one INCLUDE the others, or build a library of them, for `link`");
  }
  if (source) description.source = absolute_path(folder / text_value(*source, "source"));
  const Tree* link = root.find("link");
  if (link && !source) throw InputError(link->where, "link", "goes with a source: a library is linked already");
  std::vector<Location> link_where;
  for (const auto& [word, where] : link ? read_link(*link, folder) : std::vector<std::pair<std::string, Location>>()) {
    description.link.push_back(word);
    link_where.push_back(where);
  }
  if (library) {
    description.library = library_file(text_value(*library, "library"), folder);
    if (source && !is_made_of_source(description.library))
      throw InputError(source->where, "source",
                       "contradicts `library`: a source is compiled, so leave one of them out");
    return;
  }
  if (!is_fortran_source(description.source)) {
    throw InputError(
        source->where, "source",
        "must be a Fortran source (.f, .for, .f90, ...), found '" + one_line(description.source, 200) + "'");
  }
  FortranSource text = read_fortran_source(description.source, source->where, "source");
  text.link = description.link, text.link_where = link_where;
  const SourceLibrary made = library_of_source(text);
  description.library = made.file;
  description.library_key = "source";
  description.warnings = text.warnings;
  const Tree* symbol = root.find("symbol");
  append_all(description.warnings, made.warnings);
  append_all(description.warnings, entry_traps(text, symbol ? symbol->text : interface + "_"));
}

void read_numbers(const Tree& root, MaterialDescription& description) {
  if (const Tree* parameters = root.find("parameters")) {
    require_map(*parameters, "parameters", "the parameters of the material");
    for (const Tree::Entry& entry : parameters->entries) {
      const std::string key = "parameters." + one_line(entry.key, 80);
      description.parameters[entry.key] = number_value(entry.value, key);
      description.parameter_where[entry.key] = entry.value.where;
    }
  }
  if (const Tree* density = root.find("density")) description.density = number_value(*density, "density", positive);
  const auto below = [](double upper) { return Range{.lower = 0, .upper = upper, .lower_open = true}; };
  read_rows(root, "",
            {number_row("time_limit", description.limits.seconds, below(1e7)),
             number_row("memory_limit", description.limits.gigabytes, below(1e6))});
}

MaterialDescription mfront_description(MaterialDescription description, const std::vector<std::string>& behaviours) {
  std::string asked = description.name.empty() && behaviours.size() == 1 ? behaviours.front() : description.name;
  for (const std::string& behaviour : behaviours) {
    if (small_letters(behaviour) == asked) asked = behaviour;  // by the name that its model has here
  }
  if (!is_one_of(asked, behaviours)) {
    const std::string what = asked.empty() ? "holds several behaviours of MFront: ask for one as 'lib.so:NAME'"
                                           : "has no behaviour '" + one_line(asked, 80) + "'";
    throw InputError(description.library_where, description.library_key, "'" + description.library + "' " + what,
                     joined(behaviours));
  }
  adapters::ForeignModel model;
  model.interface = adapters::ForeignInterface::mfront;
  model.library = description.library;
  model.symbol = asked;
  description.name = model.name = small_letters(asked);
  model.temperature = 293.15;
  description.foreign = std::move(model);
  return description;
}

/// Exported symbols that look like the entry points of UMATs and VUMATs.
std::vector<std::string> subroutines_in(const std::vector<std::string>& symbols, const std::string& word) {
  std::vector<std::string> found;
  for (const std::string& symbol : symbols) {
    const std::string name = small_letters(symbol);
    const bool named = name == word || name == word + "_";
    if (named) found.insert(found.begin(), symbol);
    if (!named && name.starts_with(word + "_") && name.ends_with("_")) found.push_back(symbol);
  }
  return found;
}

/// Throws InputError where a library is one of those that need a description.
void refuse_subroutines(const MaterialDescription& description, const std::vector<std::string>& symbols) {
  std::vector<std::string> words{"vumat", "umat", "usermat"};
  for (int k = 41; k <= 50; ++k) words.push_back("umat" + std::to_string(k));
  for (const std::string& word : words) {
    const std::vector<std::string> found = subroutines_in(symbols, word);
    if (found.empty()) continue;
    const bool of_lsdyna = word.size() > 5 && word.starts_with("umat");
    const std::string interface = of_lsdyna ? "lsdyna" : word;
    const std::string usual = of_lsdyna ? "umat41_" : word + "_";
    const std::string what = of_lsdyna ? "a user material of LS-DYNA" : "a " + capital_letters(word);
    throw InputError(description.library_where, description.library_key,
                     "'" + description.library + "' exports '" + found.front() + "', " + what +
                         ": it needs a description, a YAML file with library, " + "interface: " + interface +
                         (found.front() == usual ? "" : ", symbol: " + found.front()) + ", properties and state");
  }
}

std::string yaml_of(const MaterialDescription& description, bool by_library) {
  std::string text = by_library ? "library: " + yaml_scalar(description.library) + "\n" : "";
  if (!description.source.empty()) text += "source: " + yaml_scalar(description.source) + "\n";
  if (!description.link.empty()) text += "link: " + yaml_list(description.link) + "\n";
  if (!description.name.empty()) text += "name: " + yaml_scalar(description.name) + "\n";
  text += description.foreign ? foreign_yaml(*description.foreign) : "interface: native\n";
  if (!description.parameters.empty()) text += "parameters:\n";
  for (const auto& [name, value] : description.parameters) {
    text += "  " + yaml_scalar(name) + ": " + yaml_number(value) + "\n";
  }
  const adapters::WorkerLimits usual, own = description.limits;
  if (own.seconds != usual.seconds) text += "time_limit: " + yaml_number(own.seconds) + "\n";
  if (own.gigabytes != usual.gigabytes) text += "memory_limit: " + yaml_number(own.gigabytes) + "\n";
  if (description.density) text += "density: " + yaml_number(*description.density) + "\n";
  if (!description.files.empty()) text += "files:\n";
  for (const ModelFile& file : description.files) {
    text += "  " + yaml_scalar(file.name) + ": " + yaml_scalar(file.path) + "\n";
  }
  return text;
}

}  // namespace

MaterialDescription read_description(const std::string& file) { return read_description(read_bytes(file), file); }

MaterialDescription read_description(const std::string& text, const std::string& file) {
  const Tree root = read_yaml(text, file);
  require_map(root, "", joined(keys_of("native")));
  refuse_other_kind(root, FileKind::description);
  const std::string interface = interface_of(root);
  const std::vector<std::string> known = keys_of(interface);
  refuse_keys_of_others(root, interface);
  refuse_unknown_keys(root, "", known);
  MaterialDescription description;
  read_library(root, interface, std::filesystem::path(file).parent_path(), description);
  if (const Tree* name = root.find("name")) {
    description.name = text_value(*name, "name");
    description.name_where = name->where;
    if (description.name.find('/') != std::string::npos || printable(description.name) != description.name) {
      throw InputError(name->where, "name", "'" + shown(description.name, 80) + "' is a path or cannot be printed");
    }
  }
  read_numbers(root, description);
  if (const Tree* files = root.find("files")) {
    description.files = read_model_files(*files, std::filesystem::path(file).parent_path());
  }
  if (interface != "native") {
    if (description.name.empty()) description.name = as_name(stem_of_input(file));
    description.foreign = read_foreign(root, interface, description.library, description.name, description.key_where);
    if (!description.source.empty()) {
      description.foreign->folder = std::filesystem::path(description.source).parent_path().string();
    }
  }
  return description;
}

std::string description_yaml(const MaterialDescription& description) { return yaml_of(description, true); }

std::string lasting_yaml(const MaterialDescription& description) {
  return yaml_of(description, description.source.empty());
}

void refuse_undeclared_interface(const MaterialDescription& description) {
  try {
    const std::vector<std::string> symbols = adapters::exported_symbols(description.library);
    if (std::binary_search(symbols.begin(), symbols.end(), "assay_material_entry")) return;
    std::string interface = adapters::mfront_behaviours(description.library).empty() ? "" : "mfront";
    for (const char* word : {"vumat", "umat"}) {
      if (interface.empty() && !subroutines_in(symbols, word).empty()) interface = word;
    }
    if (interface.empty()) return;
    throw InputError(
        description.library_where, description.library_key,
        "'" + description.library + "' is no plug-in of the ABI: the description lacks interface: " + interface);
  } catch (const adapters::LibraryError&) {
  }
}

MaterialDescription description_of_library(const std::string& library, const std::string& table, const Location& where,
                                           const std::string& key) {
  MaterialDescription description;
  description.library = library;
  description.name = table;
  description.library_where = description.name_where = where;
  description.library_key = key;
  try {
    const std::vector<std::string> symbols = adapters::exported_symbols(library);
    if (std::binary_search(symbols.begin(), symbols.end(), "assay_material_entry")) return description;
    const std::vector<std::string> behaviours = adapters::mfront_behaviours(library);
    if (!behaviours.empty()) return mfront_description(std::move(description), behaviours);
    refuse_subroutines(description, symbols);
  } catch (const adapters::LibraryError&) {
  }
  return description;
}

}  // namespace assay::drivers
