// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/registry.hpp"

#include <algorithm>
#include <filesystem>
#include <set>
#include <system_error>

#include "adapters/builtin.hpp"
#include "adapters/foreign/foreign_table.hpp"
#include "adapters/library.hpp"
#include "adapters/worker/probe.hpp"
#include "adapters/worker/remote_table.hpp"
#include "adapters/worker/worker_process.hpp"
#include "drivers/material/fortran_compiler.hpp"
#include "drivers/material/fortran_text.hpp"
#include "drivers/material/source_description.hpp"
#include "drivers/result/result.hpp"
#include "drivers/system/environment.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/system/own_files.hpp"
#include "drivers/system/supervisor.hpp"
#include "drivers/text/numbers.hpp"
#include "drivers/text/words.hpp"
#include "harness/material/progress_mark.hpp"

namespace assay::drivers {

namespace fs = std::filesystem;

namespace {

/// What to do with a file of another language.
std::string other_source(const std::string& file) {
  const bool other =
      is_one_of(fs::path(file).extension().string(), {".c", ".cc", ".cpp", ".cxx", ".C", ".cu", ".py", ".m", ".jl"});
  return other ? ": of sources those in Fortran are compiled here; of others build a shared library and name it, as "
                 "`assay new-material` shows"
               : "";
}

MaterialSource from_description(const std::string& file, Isolation isolation) {
  const MaterialDescription description = read_description(file);
  MaterialSource source = source_of(description, file, isolation);
  source.description = file;
  return source;
}

bool is_description(const std::string& file) { return file.ends_with(".yaml") || file.ends_with(".yml"); }

/// By a description that is kept beside its library.
MaterialSource from_source(const std::string& file, const std::string& chosen, const Location& where,
                           const std::string& key, Isolation isolation, const std::map<std::string, double>& given) {
  SourceRequest request;
  (is_fortran_source(file) ? request.symbol : request.material) = chosen;
  request.least_properties = numbered_parameters(given);
  const SourceDescription described = describe_source(file, request, where, key);
  MaterialSource source = from_description(kept_description(described.name, described.text), isolation);
  source.warnings = described.warnings;
  return source;
}

MaterialSource from_file(const std::string& file, const std::string& table, const Location& where,
                         const std::string& key, Isolation isolation, const std::map<std::string, double>& given) {
  if (const std::string fault = fault_of_file(file); !fault.empty()) throw InputError(where, key, fault);
  if (is_source_or_deck(file)) return from_source(file, table, where, key, isolation, given);
  if (is_description(file)) return from_description(file, isolation);
  if (const std::string remedy = other_source(file); !remedy.empty())
    throw InputError(where, key, "'" + one_line(file, 200) + "' is no material" + remedy);
  return source_of(description_of_library(file, table, where, key), file, isolation);
}

/// Name of a file on the search path: NAME.so, libNAME.so, NAME.yaml; empty for any other.
std::string name_of_file(const fs::path& file) {
  const std::string name = file.filename().string();
  std::string stem = file.stem().string();
  if (name.ends_with(".so") && stem.starts_with("lib")) stem.erase(0, 3);
  const bool ours = name.ends_with(".so") || name.ends_with(".yaml");
  return ours && is_material_name(stem) ? stem : std::string();
}

std::vector<RegisteredName> names_in(const std::string& folder, bool descriptions_only) {
  std::vector<RegisteredName> names;
  std::error_code code;
  for (fs::directory_iterator at(folder, code), end; !code && at != end; at.increment(code)) {
    const std::string name = name_of_file(at->path());
    if (name.empty() || (descriptions_only && !is_description(at->path().string()))) continue;
    if (std::error_code unknown_kind; !at->is_regular_file(unknown_kind)) continue;  // a pipe would be waited for
    names.push_back({name, at->path().string()});
  }
  // One name may lead to several files: NAME.yaml, which says more, before NAME.so before libNAME.so.
  const auto rank = [](const RegisteredName& n) {
    return is_description(n.file) ? 0 : fs::path(n.file).filename().string() == n.name + ".so" ? 1 : 2;
  };
  std::sort(names.begin(), names.end(),
            [&](const auto& a, const auto& b) { return a.name != b.name ? a.name < b.name : rank(a) < rank(b); });
  return names;
}

/// Throws adapters::ModelRefused.
const assay_material* local_table(const MaterialDescription& description) {
  const CallMark mark;
  const PhaseMark phase(CallPhase::loading);
  if (description.foreign) return adapters::foreign_table(*description.foreign);
  return adapters::table_of_library(description.library, description.name);
}

/// The place of the deepest key that is known: of properties.E, else of properties, else of the library.
Location place_of(const std::string& key, const MaterialDescription& description) {
  for (const std::string& part : {key, key.substr(0, key.find('.'))}) {
    if (const auto at = description.key_where.find(part); at != description.key_where.end()) return at->second;
  }
  return key == "name" ? description.name_where : description.library_where;
}

/// What is wrong, as an error at the key of the description to blame.
InputError complaint(const MaterialDescription& description, std::string key, const adapters::ModelRefused& error) {
  const std::string what = error.what();
  const bool of_library = key == "library" || key == "name" || key.empty();
  const bool absent = what == adapters::no_such_library && description.library_key == "library";
  const Location where = place_of(key, description);
  if (of_library && description.library_key != "library") key = description.library_key;
  const bool of_source = of_library && !description.source.empty();
  const bool lacks_a_routine = of_source && what.find("undefined symbol: ") != what.npos;
  return InputError(where, key.empty() ? description.library_key : key,
                    (of_library ? "'" + (of_source ? description.source : description.library) + "' " : "") + what +
                        (lacks_a_routine ? ", which `link` may bring" : "") +
                        (absent ? ", and none of that name in $ASSAY_MATERIAL_PATH" : ""),
                    error.known());
}

const assay_material* table_in_worker(const MaterialDescription& description, const std::string& file) {
  adapters::WorkerStart start;
  start.build = build_text();
  start.limits = description.limits;
  start.task = std::string(model_task) + "\n" + one_line(file) + "\n" + description_yaml(description);
  constexpr std::size_t longest = adapters::task_size / 2;  // a run puts its parameters before it
  if (start.task.size() > longest) {
    throw InputError(description.library_where, description.library_key,
                     "the description is too long for a worker: " + std::to_string(start.task.size() / 1024) +
                         " KiB with all properties and state variables, of " + std::to_string(longest / 1024));
  }
  try {
    return adapters::remote_table(start);
  } catch (const adapters::ModelRefused& error) {
    stop_if_interrupted();
    throw complaint(description, error.key(), error);
  } catch (const std::system_error& error) {
    throw SystemError(std::string("a worker cannot be started: ") + error.what());
  }
}

/// Loads it in another process first: in a copy of this one, but in a worker where this one is not ours to copy.
void try_library(const MaterialDescription& description, const std::string& file) {
  if (adapters::own_library().empty()) return adapters::try_library(description.library);
  adapters::forget_remote_table(table_in_worker(description, file));
}

const assay_material* table_here(const MaterialDescription& description, const std::string& file) {
  try {
    if (!description.foreign) try_library(description, file);
    supervise(description.library);
    return local_table(description);
  } catch (const std::system_error& error) {
    constexpr std::size_t open_files = 20;  // that the trial takes
    if (error.code() == std::errc::too_many_files_open) require_open_files(open_files);
    require_temporary_folder();
    throw SystemError(std::string("a library cannot be tried: ") + error.what());
  } catch (const adapters::LibraryError& error) {
    throw complaint(description, description.name.empty() || description.foreign ? "library" : "name", error);
  } catch (const adapters::ModelRefused& error) {
    throw complaint(description, error.key(), error);
  }
}

}  // namespace

std::size_t numbered_parameters(const std::map<std::string, double>& given) {
  std::size_t largest = 0;
  for (const auto& [name, value] : given) {
    const auto number = name.starts_with('p') ? parse_integer(name.substr(1)) : std::nullopt;
    constexpr std::int64_t most = 100000;
    if (number && *number > 0 && *number <= most) largest = std::max(largest, static_cast<std::size_t>(*number));
  }
  return largest;
}

std::string registry_folder() {
  const std::string home = own_folder("ASSAY_DATA_HOME", "XDG_DATA_HOME", "/.local/share");
  if (!home.empty() && !home.starts_with('/'))
    throw InputError({}, "ASSAY_DATA_HOME", "must be an absolute path, found '" + one_line(home, 200) + "'");
  return home.empty() ? std::string() : fs::path(home).lexically_normal().string() + "/materials";
}

std::vector<RegisteredName> registered_names() {
  auto all = mapped(adapters::builtin_tables(), [](const auto* table) { return RegisteredName{table->name, {}}; });
  if (!registry_folder().empty()) append_all(all, names_in(registry_folder(), true));
  for (const std::string& folder : material_folders()) append_all(all, names_in(folder, false));
  std::set<std::string> seen;
  std::erase_if(all, [&](const RegisteredName& n) { return !seen.insert(n.name).second; });
  return all;
}

MaterialSource find_material(const std::string& adapter, const Location& where, const std::string& key,
                             Isolation isolation, const std::map<std::string, double>& given) {
  put_files_right();
  if (is_stream(adapter)) {
    const MaterialDescription description = read_description(adapter);
    MaterialSource source = source_of(description, adapter, isolation);
    source.description = kept_description("stdin", lasting_yaml(description));
    return source;
  }
  const MaterialName asked = parse_material(adapter);
  if (asked.is_path) return from_file(absolute_path(asked.file), asked.table, where, key, isolation, given);
  const std::vector<RegisteredName> names = registered_names();
  for (const RegisteredName& registered : names) {
    if (registered.name != adapter) continue;
    if (!registered.file.empty()) return from_file(registered.file, {}, where, key, isolation, {});
    MaterialSource source;
    source.table = adapters::builtin_table(adapter);
    return source;
  }
  const std::vector<std::string> known = mapped(names, &RegisteredName::name);
  throw InputError(where, key,
                   unknown("material '" + one_line(adapter, 80) + "'", adapter, known) + other_source(adapter),
                   joined(known));
}

MaterialSource source_of(const MaterialDescription& description, const std::string& file, Isolation isolation) {
  if (!description.foreign && description.library_key == "library") refuse_undeclared_interface(description);
  note_input(description.library);
  if (!description.source.empty()) note_input(description.source);
  for (const ModelFile& model_file : description.files) note_input(model_file.path);
  MaterialSource source{description};
  const bool own_process = description.foreign || !description.files.empty();
  const bool apart = isolation == Isolation::worker || (isolation == Isolation::automatic && own_process);
  source.isolation = apart ? Isolation::worker : Isolation::none;
  source.table = apart ? table_in_worker(description, file) : table_here(description, file);
  return source;
}

const assay_material* table_of_task(const std::string& task) {
  const std::size_t line = task.find('\n');
  const MaterialDescription description = read_description(task.substr(line + 1), task.substr(0, line));
  place_model_files(description.files);
  return local_table(description);
}

void serve_material(adapters::WorkerFloor& floor, const std::string& task) {
  adapters::serve_model(floor, [&] { return table_of_task(task); });
}

}  // namespace assay::drivers
