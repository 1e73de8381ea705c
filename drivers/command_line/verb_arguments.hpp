// SPDX-License-Identifier: BSD-3-Clause
// Arguments that several verbs take.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "drivers/command_line/verb.hpp"
#include "drivers/findings/run_options.hpp"
#include "drivers/material/source_options.hpp"

namespace assay::drivers {

/// What is a file of materials, for VerbArguments::offers.
inline const std::string material_files = "*.so *.yaml *.yml *.f *.for *.ftn *.f77 *.f90 *.f95 *.F *.FOR *.F90 *.inp";

/// An option with a value, or an argument if the name has no dash. type: what the help calls the value; empty for an
/// argument. offers: what a shell completes it with, as in VerbArguments.
CLI::Option* add_value(VerbArguments& verb, const std::string& name, std::string& value, const std::string& type,
                       const std::string& doc, const std::string& offers = {});

/// An option that is given several times, with one value each.
void add_repeatable(VerbArguments& verb, const std::string& name, std::vector<std::string>& values,
                    const std::string& type, const std::string& doc);

/// SCENE and --set.
void add_scene(VerbArguments& verb, SceneOptions& given);

/// -o, which takes no empty name. type: DIR or CSV.
void add_out(VerbArguments& verb, std::string& out, const std::string& type, const std::string& doc);

/// -o and --json of a verb that leaves a folder of results.
void add_results(VerbArguments& verb, SceneOptions& given);

/// The folder `out`; where it is empty, results/NAME with the name of the input.
std::string results_folder(const std::string& out, const std::string& input);

/// --junit and --junit-name. doc: of --junit.
void add_junit(VerbArguments& verb, std::string& file, std::string& name, const std::string& doc);

/// Throws InputError where there is a --junit-name without --junit.
void require_junit_of_name(const std::string& verb, const std::string& file, const std::string& name);

/// The act of a verb whose options the arguments fill.
template <class Options>
Act act_of(const std::shared_ptr<Options>& given, int (*verb)(const Options&)) {
  return [given, verb](Verbosity verbosity) {
    given->verbosity = verbosity;
    return verb(*given);
  };
}

/// What is said of a Fortran source.
void add_source_options(VerbArguments& verb, SourceOptions& source);

/// The number of threads or processes that `option` asks for; `otherwise` where the text is empty. Throws InputError.
int count_in(const std::string& option, const std::string& text, int otherwise);

}  // namespace assay::drivers
