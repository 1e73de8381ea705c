// SPDX-License-Identifier: BSD-3-Clause
// A verb of the command line, as its file in drivers/verbs describes it.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "drivers/findings/run_options.hpp"
#include "drivers/material/source_description.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace assay::drivers {

/// What a verb takes on the command line.
struct VerbArguments {
  CLI::App& app;
  /// What a shell completes a value with, if its type (FILE, FILE.inp, CSV, DIR) does not tell: words, files
  /// ("*.yaml"), folders ("*/"), with a blank between them. "@materials" stands for the names of all registered
  /// materials.
  std::map<const CLI::Option*, std::string> offers = {};
};

/// Does what the arguments ask for, once they are read. Returns the exit status of the process. Bad input is thrown as
/// InputError (2), failures of the system as SystemError (3).
using Act = std::function<int(Verbosity)>;

/// drivers/verbs/new_material.cpp is the verb new-material. It defines `Verb verb_new_material()`.
struct Verb {
  int place;                   ///< in `assay --help`, the lowest first
  const char *doc, *example;   ///< line of the help; commands, as the help shows them
  Act (*add)(VerbArguments&);  ///< defines the arguments, but for --help, --quiet and --verbose
};

/// A verb that the command line has.
struct AddedVerb {
  std::string name;
  VerbArguments arguments;
  Act act;
};

/// Adds all verbs of drivers/verbs, in the order of their places, and --quiet and --verbose to each and to `app`. The
/// flags outlive `app`.
std::vector<AddedVerb> add_verbs(CLI::App& app, bool& quiet, bool& verbose);

/// What a shell offers where the tab key is pressed: a line for each thing that may stand in place of the last of the
/// words, which follow `assay`: a word, a tab and its meaning; "*.csv" for files of that kind; "*" for all files; "*/"
/// for folders. The scripts of completions/ ask for it.
std::string completions(const CLI::App& app, const std::vector<AddedVerb>& verbs,
                        const std::vector<std::string>& words);

/// The man page: `page`, which is docs/assay.1 in roff with a section `.SS assay VERB` for a verb, with an entry for
/// each option that the section of its verb does not name, and with a section for each verb that has none, both in the
/// words of the help.
std::string whole_manual(const CLI::App& app, const std::vector<AddedVerb>& verbs, std::string page);

// Arguments that several verbs take.

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
void add_results(VerbArguments& verb, SceneOptions& given, const std::string& json = "result.json");

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
