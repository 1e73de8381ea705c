// SPDX-License-Identifier: BSD-3-Clause
#include "drivers/material/material_table.hpp"

#include <system_error>

#include "adapters/foreign/foreign_table.hpp"
#include "adapters/library.hpp"
#include "adapters/worker/probe.hpp"
#include "adapters/worker/remote_table.hpp"
#include "adapters/worker/worker_process.hpp"
#include "drivers/material/model_files.hpp"
#include "drivers/material/raw_library.hpp"
#include "drivers/system/input_file.hpp"
#include "drivers/system/interrupt.hpp"
#include "drivers/system/own_files.hpp"
#include "drivers/system/supervisor.hpp"
#include "harness/material/progress_mark.hpp"

namespace assay::drivers {

namespace {

/// Throws adapters::ForeignError, adapters::LibraryError.
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
InputError complaint(const MaterialDescription& description, std::string key, const std::string& what,
                     const std::string& known) {
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
                    known);
}

adapters::ModelRefused refusal_of(const MaterialDescription& description, const adapters::LibraryError& error) {
  return {description.name.empty() || description.foreign ? "library" : "name", error.what(), error.known()};
}

const assay_material* table_here(const MaterialDescription& description) {
  try {
    if (!description.foreign) adapters::try_library(description.library);
    supervise(description.library);
    return local_table(description);
  } catch (const std::system_error& error) {
    constexpr std::size_t open_files = 20;  // that the trial takes
    if (error.code() == std::errc::too_many_files_open) require_open_files(open_files);
    require_temporary_folder();
    throw SystemError(std::string("a library cannot be tried: ") + error.what());
  } catch (const adapters::ForeignError& error) {
    throw complaint(description, error.key(), error.what(), error.known());
  } catch (const adapters::LibraryError& error) {
    const adapters::ModelRefused refused = refusal_of(description, error);
    throw complaint(description, refused.key, refused.what, refused.known);
  }
}

const assay_material* table_in_worker(const MaterialDescription& description, const std::string& file) {
  adapters::WorkerStart start;
  start.limits = description.limits;
  start.task = std::string(model_task) + "\n" + one_line(file) + "\n" + description_yaml(description);
  constexpr std::size_t longest = adapters::task_size / 2;
  if (start.task.size() > longest) {
    throw InputError(description.library_where, description.library_key,
                     "the description is too long for a worker: " + std::to_string(start.task.size() / 1024) +
                         " KiB with all properties and state variables, of " + std::to_string(longest / 1024));
  }
  try {
    return adapters::remote_table(start);
  } catch (const adapters::RemoteError& error) {
    stop_if_interrupted();
    throw complaint(description, error.refused.key, error.refused.what, error.refused.known);
  } catch (const std::system_error& error) {
    throw SystemError(std::string("a worker cannot be started: ") + error.what());
  }
}

}  // namespace

MaterialSource source_of(const MaterialDescription& description, const std::string& file, Isolation isolation) {
  if (!description.foreign && description.library_key == "library") refuse_undeclared_interface(description);
  note_input(description.library);
  if (!description.source.empty()) note_input(description.source);
  for (const ModelFile& model_file : description.files) note_input(model_file.path);
  MaterialSource source;
  const bool own_process = description.foreign || !description.files.empty();
  const bool apart = isolation == Isolation::worker || (isolation == Isolation::automatic && own_process);
  source.isolation = apart ? Isolation::worker : Isolation::none;
  source.table = apart ? table_in_worker(description, file) : table_here(description);
  source.foreign = description.foreign;
  source.library = description.library;
  source.parameters = description.parameters;
  source.parameter_where = description.parameter_where;
  source.density = description.density;
  source.source = description.source;
  source.files = description.files;
  source.warnings = description.warnings;
  return source;
}

const assay_material* table_of_task(const std::string& task) {
  const std::size_t line = task.find('\n');
  const MaterialDescription description = read_description(task.substr(line + 1), task.substr(0, line));
  place_model_files(description.files);
  return local_table(description);
}

void serve_material(adapters::WorkerFloor& floor, const std::string& task) {
  adapters::serve_model(floor, [&]() -> const assay_material* {
    try {
      return table_of_task(task);
    } catch (const adapters::ForeignError& error) {
      throw adapters::ModelRefused{error.key(), error.what(), error.known()};
    } catch (const adapters::LibraryError& error) {
      throw adapters::ModelRefused{"library", error.what(), error.known()};
    }
  });
}

}  // namespace assay::drivers
