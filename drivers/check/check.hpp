// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "drivers/material/source_options.hpp"

namespace assay::drivers {

struct CheckOptions {
  std::string material;    ///< name, library, description, source, deck or scene; with `methods` that of one, or empty
  std::string parameters;  ///< "E=1e3,nu=0.3"
  std::string json;        ///< file; "-": standard output; empty: none
  std::string junit;       ///< the same
  std::string out;         ///< folder of the replay files
  std::string replay;      ///< file of a failure to be taken again, in place of a material
  bool all = false;        ///< everything that is registered, in place of a material
  bool quick = false;
  Verbosity verbosity = Verbosity::normal;
  bool methods = false;                              ///< the patch tests of the particle method, in place of a material
  std::optional<double> strain = {}, pressure = {};  ///< of the battery's histories [1], at rest [Pa]
  std::optional<double> step = {};                   ///< the longest usual step [s]
  std::string markdown = {};                         ///< file of the methods' table; "-": standard output
  std::string junit_name = {};                       ///< of the suite in the JUnit file; empty: the material's
  SourceOptions source = {};
};

/// Tests a material, all that are registered, or the particle methods, and tells the verdicts. Returns 0 where all
/// pass, otherwise 1, or 2 where a material could not be checked. Throws InputError, SystemError.
int check(const CheckOptions& options);

/// The patch tests of the particle method `options.material`; of all where that is empty.
int check_methods(const CheckOptions& options);

}  // namespace assay::drivers
