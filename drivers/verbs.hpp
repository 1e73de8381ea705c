// SPDX-License-Identifier: BSD-3-Clause
// What the verbs of the command line take. Each returns the exit status of the process; bad input is thrown as
// InputError (2), failures of the system as SystemError (3).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drivers/study/shard.hpp"

namespace assay::drivers {

/// How much a verb says on standard error.
enum class Verbosity { quiet, normal, verbose };

struct RunOptions {
  std::string scene;
  std::string out;                ///< folder; never empty: results/SCENE by default
  std::vector<std::string> sets;  ///< "key.path=YAML value", in the order given
  int threads = 1;
  bool json = false;  ///< result.json on standard output
  Verbosity verbosity = Verbosity::normal;
  std::string junit = {};       ///< file; "-": standard output; empty: none
  std::string junit_name = {};  ///< of the suite in that file; empty: the scene's
};

struct TabulateOptions {
  std::string scene;
  std::string out;  ///< folder, as in RunOptions
  std::vector<std::string> sets;
  std::string points;  ///< CSV of xi,t; empty: none
  bool json = false;
  Verbosity verbosity = Verbosity::normal;
};

struct EvalOptions {
  std::string scene;
  std::string points;  ///< CSV of X,Y,t
  std::string out;     ///< CSV file; empty: standard output
  std::vector<std::string> sets;
  Verbosity verbosity = Verbosity::normal;
};

struct ExplainOptions {
  std::string scene;
  std::vector<std::string> sets;
  bool json = false;
  Verbosity verbosity = Verbosity::normal;
};

/// What is said of a material that is a Fortran source, as it stands on the command line; empty: nothing.
struct SourceOptions {
  std::string props;     ///< "1000,.3", "E=1000,nu=.3"
  std::string statev;    ///< number of STATEV
  std::string deck;      ///< Abaqus input file
  std::string material;  ///< of the deck
  std::string symbol;    ///< entry point
  std::string link;      ///< "lapack,./mine.a"
};

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

struct MaterialsOptions {
  std::string name = {};  ///< registered name, library or description; empty: all that is registered
  bool json = false;
  bool names = false;  ///< of all that is registered, without a look into the libraries
  Verbosity verbosity = Verbosity::normal;
};

struct RegisterOptions {
  std::string file;    ///< library, `library:name`, description, source or deck; empty with `remove`
  std::string name;    ///< empty: the material's own, or the description's file name
  std::string remove;  ///< name to take out of the registry; empty: none
  Verbosity verbosity = Verbosity::normal;
  SourceOptions source = {};
};

struct NewMaterialOptions {
  std::string name;
  std::string language;              ///< c, c++ or fortran
  std::string interface = "native";  ///< or umat, in Fortran
  std::string out;                   ///< the folder to be made; empty: the name
  Verbosity verbosity = Verbosity::normal;
};

struct StudyOptions {
  std::string study;
  std::string out;                     ///< folder of the results
  int jobs = 1;                        ///< threads of cases that run side by side
  Shard shard = {};                    ///< the cases of this call
  bool resume = false;                 ///< finished cases stay
  bool merge = false;                  ///< nothing is run: what is there is put together
  std::vector<std::string> from = {};  ///< folders whose finished cases are taken over before
  bool list = false;                   ///< the cases, and nothing else
  bool json = false;                   ///< study.json on standard output
  Verbosity verbosity = Verbosity::normal;
  std::string program = {};  ///< that runs a case; empty: this one
};

struct RecommendOptions {
  std::string study;  ///< folder of a study's results, its study.json, or the study's YAML file
  /// That is wanted: a number in the study's unit, or "1 %"; without, the method that lives through most is named.
  std::optional<std::string> error;
  std::string out;  ///< folder of the results of a YAML file; empty: results/NAME
  bool json = false;
};

struct CompareOptions {
  std::string before, after;  ///< folders of results, or their study.json
  std::string markdown;       ///< file; "-": standard output; empty: none
  bool json = false;
  Verbosity verbosity = Verbosity::normal;  ///< verbose: the cases that are the same, too; quiet: the verdict alone
};

struct SchemaOptions {
  bool study = false;  ///< of studies in place of scenes
};

int run(const RunOptions& options);
int study(const StudyOptions& options);
int tabulate(const TabulateOptions& options);
int eval(const EvalOptions& options);
int explain(const ExplainOptions& options);
int recommend(const RecommendOptions& options);
int compare(const CompareOptions& options);
int check(const CheckOptions& options);
int check_methods(const CheckOptions& options);
int materials(const MaterialsOptions& options);
int register_material(const RegisterOptions& options);
int new_material(const NewMaterialOptions& options);
int schema(const SchemaOptions& options);

}  // namespace assay::drivers
