// SPDX-License-Identifier: BSD-3-Clause
// The YAML description of a library's material: {library, name, interface, parameters, density}, what a foreign
// interface does not say of itself, and files that the model opens where it works. A library that nobody has described
// is described by what it exports.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "adapters/foreign/foreign_model.hpp"
#include "adapters/process/fate.hpp"
#include "drivers/format/yaml_reader.hpp"
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
  std::vector<std::string> link = {};             ///< what the source is linked with: words of linked_word()
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

/// A list of paths relative to `folder`, or a map from names to paths. A path that stays below the folder keeps it as
/// its name, another is known by its last part. Throws InputError: no such file, a name that leads out of a folder, two
/// of one name.
std::vector<ModelFile> read_model_files(const Tree& tree, const std::filesystem::path& folder);

/// Copies them to the folder in which this process stands: one of its own. What is there stays. Throws SystemError.
void place_model_files(const std::vector<ModelFile>& files);

/// The description of a library that describes itself: of the material ABI, or of MFront's generic interface. table:
/// which of its models; empty: its only one. where, key: who names it. Throws InputError: a UMAT or VUMAT, which needs
/// a description; none or several behaviours; nothing that is known. A library that cannot be read is left to whoever
/// loads it.
MaterialDescription description_of_library(const std::string& library, const std::string& table, const Location& where,
                                           const std::string& key);

/// Of a description that names no foreign interface: throws InputError where its library can be of no other, as that of
/// a UMAT. A library that cannot be read is left to whoever loads it.
void refuse_undeclared_interface(const MaterialDescription& description);

}  // namespace assay::drivers
