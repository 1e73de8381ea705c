// SPDX-License-Identifier: BSD-3-Clause
// What verbs of a scene are asked for.
#pragma once

#include <string>
#include <vector>

#include "drivers/system/terminal.hpp"

namespace assay::drivers {

struct SceneOptions {
  std::string scene;
  std::string out;                ///< folder, never empty: results/SCENE by default; of `eval` a file, or empty
  std::vector<std::string> sets;  ///< "key.path=YAML value", in the order given
  bool json = false;              ///< JSON on standard output
  Verbosity verbosity = Verbosity::normal;

  bool quiet() const { return verbosity == Verbosity::quiet; }
};

struct RunOptions : SceneOptions {
  int threads = 1;
  std::string junit = {};       ///< file; "-": standard output; empty: none
  std::string junit_name = {};  ///< of the suite in that file; empty: the scene's
};

}  // namespace assay::drivers
