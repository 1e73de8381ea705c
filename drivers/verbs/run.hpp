// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "drivers/verbosity.hpp"

namespace assay::drivers {

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

/// From a scene to a verdict: leaves its results in the folder and tells of them. Returns the exit status: 0 where all
/// that was expected holds, otherwise 1. Throws InputError, SystemError.
int run(const RunOptions& options);

}  // namespace assay::drivers
