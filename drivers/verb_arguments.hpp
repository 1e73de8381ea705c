// SPDX-License-Identifier: BSD-3-Clause
// The verbs of the command line and what they take.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "drivers/verbs.hpp"

namespace CLI {
class App;
}

namespace assay::drivers {

/// Everything that any verb takes, as text.
struct Arguments {
  std::string scene, out, points, threads, material, file, name, remove, parameters, json_file, junit_file, replay;
  std::string markdown_file;
  std::string language, interface = "native", strain, pressure;
  std::vector<std::string> sets;
  bool json = false, quick = false, all = false, methods = false, quiet = false, verbose = false;

  Verbosity verbosity() const { return quiet ? Verbosity::quiet : verbose ? Verbosity::verbose : Verbosity::normal; }
  std::string folder() const;  ///< of the results
  int thread_count() const;    ///< throws InputError
};

/// A verb and what it does with the arguments once they are read.
struct Verb {
  CLI::App* app = nullptr;
  std::function<int()> act;
};

/// Adds run, tabulate, eval and explain. `given` outlives the verbs.
std::vector<Verb> scene_verbs(CLI::App& app, Arguments& given);

/// Adds check, materials, register, new-material and schema.
std::vector<Verb> material_verbs(CLI::App& app, Arguments& given);

/// --quiet and --verbose.
void add_verbosity(CLI::App& app, Arguments& given);

}  // namespace assay::drivers
