// SPDX-License-Identifier: BSD-3-Clause
// Verbs as functions, for tests and benchmarks; each is in the file of its name. They return the exit status, and throw
// InputError and SystemError.
#pragma once

#include <string>

#include "drivers/findings/run_options.hpp"
#include "drivers/material/source_description.hpp"

namespace assay::drivers {

/// From a scene to a verdict: leaves its results in the folder and tells of them. 0 where all that was expected holds,
/// otherwise 1.
int run(const RunOptions& options);

struct TabulateOptions : SceneOptions {
  std::string points;  ///< CSV of xi,t; empty: none
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
