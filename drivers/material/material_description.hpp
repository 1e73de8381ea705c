// SPDX-License-Identifier: BSD-3-Clause
// The YAML description of a library's material: {library, name, interface, parameters, density}, and what a foreign
// interface does not say of itself.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "adapters/foreign/foreign_model.hpp"
#include "adapters/process/fate.hpp"
#include "drivers/system/input_error.hpp"

namespace assay::drivers {

/// A file that a model opens where it works.
struct ModelFile {
  std::string name;  ///< there, relative to the folder
  std::string path;  ///< absolute: what is copied
};

struct MaterialDescription {
  std::string library;                       ///< absolute path
  std::string name;                          ///< of the table; empty: the library's only one
  std::map<std::string, double> parameters;  ///< in place of the material's own defaults
  std::optional<double> density;             ///< rho0 [kg/m^3]
  Location library_where, name_where;
  std::map<std::string, Location> parameter_where;
  std::optional<adapters::ForeignModel> foreign;  ///< of interfaces other than the native one
  adapters::WorkerLimits limits;                  ///< of a worker: seconds a call, GB of memory
  std::map<std::string, Location> key_where;      ///< places of its keys
  std::string library_key = "library";            ///< the key that named the library, for messages
  std::string source = {};                        ///< absolute path of the Fortran source of the library; empty: none
  std::vector<std::string> link = {};             ///< what the source is linked with: linked.hpp
  std::vector<ModelFile> files = {};              ///< of the folder of a process of its own
  std::vector<std::string> warnings = {};         ///< sentences on the source
};

/// Strict. Paths are relative to the file's folder. A source without a library is compiled. Throws InputError, and
/// SystemError where that cannot be done.
MaterialDescription read_description(const std::string& file);
MaterialDescription read_description(const std::string& text, const std::string& file);

/// YAML text that reads back to the same description: by its library, so that nothing is compiled.
std::string description_yaml(const MaterialDescription& description);

/// The same for a file that is kept: of a source, so that it is compiled when it has changed.
std::string lasting_yaml(const MaterialDescription& description);

}  // namespace assay::drivers
