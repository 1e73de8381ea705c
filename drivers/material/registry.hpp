// SPDX-License-Identifier: BSD-3-Clause
// Where names of materials lead: built-in, the user's registry, the folders of $ASSAY_MATERIAL_PATH; and from a
// description to a table, in this process or in a worker.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "adapters/worker/worker.hpp"
#include "drivers/material/material_description.hpp"
#include "drivers/scene/material_path.hpp"
#include "drivers/system/input_error.hpp"
#include "harness/assay_material.h"

namespace assay::drivers {

/// A material that was found: its description, which is empty but for the table where it is built in.
struct MaterialSource : MaterialDescription {
  const assay_material* table = nullptr;
  std::string description = {};  ///< the YAML file that led to it; empty: none
  Isolation isolation = Isolation::none;
};

/// A name that can be asked for. `file`: the library or description; empty: built in.
struct RegisteredName {
  std::string name, file;
};

/// By name (built-in, registry, $ASSAY_MATERIAL_PATH, in that order) or by path (library, `library:name`, description,
/// Fortran source, Abaqus deck). given: the parameters that somebody has for it; of a source their number counts.
/// Throws InputError at `where`, `key`; SystemError where a source cannot be compiled here.
MaterialSource find_material(const std::string& adapter, const Location& where, const std::string& key,
                             Isolation isolation = Isolation::automatic,
                             const std::map<std::string, double>& given = {});

/// Of p1, p2, ... among the names of parameters, the largest number.
std::size_t numbered_parameters(const std::map<std::string, double>& given);

/// All names in the order of the search, each once: as find_material would take it.
std::vector<RegisteredName> registered_names();

/// The folder of the registry, ${ASSAY_DATA_HOME:-$XDG_DATA_HOME/assay}/materials; empty where there is no home. Throws
/// InputError where ASSAY_DATA_HOME is no absolute path.
std::string registry_folder();

/// With the table, library, parameters and density of the description; `file` stands for it in messages. Throws
/// InputError at the key to blame.
MaterialSource source_of(const MaterialDescription& description, const std::string& file, Isolation isolation);

/// What a worker does whose task is a model: answers calls until its host ends.
void serve_material(adapters::WorkerFloor& floor, const std::string& task);

/// The table that a task of that kind names, in this process, in whose folder its files are laid. Throws InputError,
/// and what adapters throw.
const assay_material* table_of_task(const std::string& task);

/// Tasks of workers begin with one of these words and a line's end.
inline constexpr const char* model_task = "model";

}  // namespace assay::drivers
