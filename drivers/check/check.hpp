// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/material/material_choice.hpp"
#include "drivers/material/source_description.hpp"

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
  int dimension = 2;                                 ///< in which the methods are tested: 2 or 3
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

/// Takes the step of a replay file again, as it is and from a turned frame, then the test that failed. Returns 1 where
/// it fails again, 0 where it does not. Throws InputError.
int check_replay(const CheckOptions& options);

/// What was found, as the options ask for it. Throws SystemError.
void tell_check(const CheckOptions& options, const std::string& text, const std::string& json, const std::string& junit,
                const std::string& markdown = {});

/// "E=1e3,nu=0.3": names and numbers. Throws InputError.
std::map<std::string, double> parameters_in(const std::string& list);

/// The material of a scene, a source, a description, a library or a name, made in a worker. Throws InputError.
ResolvedMaterial material_to_check(const CheckOptions& options);

/// At what its author shows it, where its parameters have no default; `given` before all, as far as it takes them.
ResolvedMaterial registered_material(const std::string& name, const std::map<std::string, double>& given);

// What the causes mean that a check can name: docs/causes.md, which the build puts into the program.

/// The whole page, as written.
std::string_view causes_page();

/// The causes that the page has a section for, in its order.
std::vector<std::string> explained_causes();

/// The section of a cause for a terminal of 80 columns: its name, paragraphs that are wrapped, lists and code; empty
/// where the page has none.
std::string explained_cause(const std::string& cause);

/// `check --explain CAUSE`: prints that section; for "all" the list of causes. Throws InputError.
int explain_cause(const std::string& cause);

}  // namespace assay::drivers
