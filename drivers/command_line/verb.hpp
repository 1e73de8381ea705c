// SPDX-License-Identifier: BSD-3-Clause
// A verb of the command line, as its file in drivers/verbs describes it.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "drivers/text/verbosity.hpp"

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

}  // namespace assay::drivers
