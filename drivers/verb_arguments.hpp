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
  std::string scene, out, points, threads, material, file, name, remove, parameters, json_file, junit_file, junit_name,
      replay;
  std::string markdown_file, study, after, jobs, shard;
  std::optional<std::string> error, explain;
  std::string language, interface = "native", strain, pressure, step;
  SourceOptions source;
  std::vector<std::string> sets, from;
  bool resume = false, merge = false, list = false, of_studies = false;
  bool json = false, names = false, quick = false, all = false, methods = false, quiet = false, verbose = false;

  Verbosity verbosity() const { return quiet ? Verbosity::quiet : verbose ? Verbosity::verbose : Verbosity::normal; }
  std::string folder() const;        ///< of the results of a scene
  std::string study_folder() const;  ///< of a study
  int thread_count() const;          ///< throws InputError
};

/// A verb and what it does with the arguments once they are read.
struct Verb {
  CLI::App* app = nullptr;
  std::function<int()> act;
};

/// Adds run, tabulate, eval and explain. `given` outlives the verbs.
std::vector<Verb> scene_verbs(CLI::App& app, Arguments& given);

/// Adds study, recommend and compare.
std::vector<Verb> study_verbs(CLI::App& app, Arguments& given);

/// Adds check, materials, register, new-material and schema.
std::vector<Verb> material_verbs(CLI::App& app, Arguments& given);

/// A verb with its line of help and an example.
CLI::App& add_verb(CLI::App& app, const std::string& name, const std::string& doc, const std::string& example);

/// -o, which takes no empty name.
void add_out(CLI::App& verb, Arguments& given, const std::string& type, const std::string& doc);

/// --quiet and --verbose.
void add_verbosity(CLI::App& app, Arguments& given);

}  // namespace assay::drivers
