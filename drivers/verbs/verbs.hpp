// SPDX-License-Identifier: BSD-3-Clause
// Verbs as functions, for tests and benchmarks; each is in the file of its name. They return the exit status, and throw
// InputError and SystemError.
#pragma once

#include <string>
#include <vector>

#include "drivers/export/export.hpp"
#include "drivers/findings/run_options.hpp"
#include "drivers/material/source_description.hpp"

namespace assay::drivers {

/// From a scene to a verdict: leaves its results in the folder and tells of them. 0 where all that was expected holds,
/// otherwise 1.
int run(const RunOptions& options);

struct TabulateOptions : SceneOptions {
  std::string points;                     ///< CSV of xi,t; empty: none
  std::vector<std::string> defines = {};  ///< NAME=VALUE of an MTest file
  std::string material = {};              ///< in place of its behaviour
  std::string increments = {};            ///< of a path: "8,16,32", in place of the scene's own; empty: these
};

/// Leaves the sheet of a scene's material, its slope and its curve in the folder. The same status.
int tabulate(const TabulateOptions& options);

struct EvalOptions : SceneOptions {
  std::string points;        ///< CSV or arrays of X,Y,t
  std::string times = {};    ///< of all points, where they have no t: numbers, or a file; empty: none
  std::string columns = {};  ///< that are wanted; empty: all
  std::string format = {};   ///< csv, npy, npz or vtu; empty: as the suffix of `out` says
  bool is_static = false;    ///< b is -DIV(P)/rho0, as with force.quasi_static
};

/// Writes the exact fields of a motion at the points into the file `out`. 1 where the material fails.
int eval(const EvalOptions& options);

/// Writes what another code needs to run the scene. 1 where the material fails.
int export_scene(const ExportOptions& options);

struct JudgeOptions : SceneOptions {
  std::vector<std::string> runs;  ///< files or folders, one for each grid
  std::string map = {};           ///< file or preset; empty: names are recognised
  std::string spacings = {};      ///< of the runs, "0.1,0.05" [m]; empty: the distance between particles
  std::string order = {};         ///< that is asked for; empty: none
  std::string junit = {}, junit_name = {};
};

/// Measures the output of another code against the scene's exact motion, leaves its findings in the folder and tells of
/// them. 0 where nothing is wrong, otherwise 1.
int judge_runs(const JudgeOptions& options);

struct StandardOptions {
  std::string action = "run";        ///< list, run, export or judge
  std::string target = {};           ///< of export
  std::vector<std::string> folders;  ///< results of other codes
  std::vector<std::string> only;     ///< ids of problems; empty: all
  int edition = 1;
  std::string out = "results/standard", markdown = {};
  bool json = false, quiet = false;
  std::string program = "/proc/self/exe";  ///< that runs a problem
};

/// Lists the standard set, runs it or judges it, and leaves the card in the folder. 0 where every problem that was run
/// is good, otherwise 1.
int standard(const StandardOptions& options);

using ExplainOptions = SceneOptions;

/// Prints what a run of the scene consists of. 1 where the material fails.
int explain(const ExplainOptions& options);

struct MaterialsOptions {
  std::string name = {};  ///< registered name, library or description; empty: all that is registered
  bool json = false;
  bool names = false;  ///< of all that is registered, without a look into the libraries
  Verbosity verbosity = Verbosity::normal;
};

/// Prints what is registered, or one material.
int materials(const MaterialsOptions& options);

struct NewMaterialOptions {
  std::string name;
  std::string language;              ///< c, c++ or fortran
  std::string interface = "native";  ///< or umat, in Fortran
  std::string out;                   ///< the folder to be made; empty: the name
  Verbosity verbosity = Verbosity::normal;
};

/// Writes a project of a material.
int new_material(const NewMaterialOptions& options);

struct RegisterOptions {
  std::string file;    ///< library, `library:name`, description, source or deck; empty with `remove`
  std::string name;    ///< empty: the material's own, or the description's file name
  std::string remove;  ///< name to take out of the registry; empty: none
  Verbosity verbosity = Verbosity::normal;
  SourceOptions source = {};
};

/// Gives a material a name in the user's registry, or removes one.
int register_material(const RegisterOptions& options);

}  // namespace assay::drivers
